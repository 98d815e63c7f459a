using UnityEngine;
using UnityEngine.Rendering;

namespace Nowpose.Unity.Calibration
{
    /// <summary>An object in the scene that holds one patch of a rendering load.</summary>
    sealed class LoadSlot
    {
        readonly GameObject _object;
        readonly MeshFilter _filter;
        readonly MeshRenderer _renderer;
        Mesh _mesh;

        public LoadSlot(Transform parent, Material material)
        {
            _object = new GameObject("Load Patch") { layer = parent.gameObject.layer };
            _object.transform.SetParent(parent, worldPositionStays: false);
            _filter = _object.AddComponent<MeshFilter>();
            _renderer = _object.AddComponent<MeshRenderer>();
            _renderer.sharedMaterial = material;
            _renderer.enabled = false;
        }

        /// <summary>Number of vertices of the completed patch, even while it is hidden; 0 while the patch is being built.</summary>
        public int Vertices { get; private set; }

        public bool IsShown
        {
            get => _renderer.enabled;
            set => _renderer.enabled = value;
        }

        /// <summary>Removes the previous patch and starts a new patch with these vertices.</summary>
        public void SetVertices(Vector3[] vertices, Vector3[] normals, int count)
        {
            Free();
            // Uses 32-bit indices, so the GPU reads as many index bytes as for one large mesh.
            _mesh = new Mesh { name = "Load Patch", indexFormat = IndexFormat.UInt32 };
            _mesh.SetVertices(vertices, 0, count);
            _mesh.SetNormals(normals, 0, count);
        }

        public void SetTriangles(int[] indices, int count) => _mesh.SetTriangles(indices, 0, count, 0);

        /// <summary>Uploads the patch to the GPU and frees its CPU memory.</summary>
        public void Show()
        {
            _mesh.UploadMeshData(markNoLongerReadable: true);
            _filter.sharedMesh = _mesh;
            Vertices = _mesh.vertexCount;
            IsShown = true;
        }

        public void Destroy()
        {
            Free();
            Object.Destroy(_object);
        }

        void Free()
        {
            if (_mesh != null) Object.Destroy(_mesh);
            _mesh = null;
            Vertices = 0;
        }
    }
}
