using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class MeshFilter : Component
{
    [SerializeField, SerializedName("m_Mesh")] Mesh _mesh;

    public Mesh sharedMesh
    {
        get => _mesh;
        set => _mesh = value;
    }

    /// <summary>A copy of its own, made when first asked for.</summary>
    public Mesh mesh
    {
        get
        {
            if (!_mesh) _mesh = new Mesh();
            else if (!_mesh.name.EndsWith(" Instance", System.StringComparison.Ordinal)) _mesh = Named((Mesh)_mesh.Duplicate(), _mesh.name + " Instance");
            return _mesh;
        }
        set => _mesh = value;
    }

    static Mesh Named(Mesh mesh, string name)
    {
        mesh.name = name;
        return mesh;
    }
}
