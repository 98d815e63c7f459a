using UnityEngine.Rendering;
using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class Mesh : Object
{
    readonly List<int[]> _triangles = new() { Array.Empty<int>() };
    Vector3[] _vertices = Array.Empty<Vector3>();
    Vector3[] _normals = Array.Empty<Vector3>();

    public IndexFormat indexFormat { get; set; }
    public Bounds bounds { get; set; }
    public int vertexCount => _vertices.Length;

    public Vector3[] vertices
    {
        get => Copy(_vertices);
        set
        {
            ThrowIfUploaded();
            _vertices = Copy(value);
            MeasureBounds();
        }
    }

    public Vector3[] normals
    {
        get => Copy(_normals);
        set => _normals = Copy(value);
    }

    /// <summary>Triangles of all submeshes, with three vertex indices per triangle, clockwise as seen from outside.</summary>
    public int[] triangles
    {
        get
        {
            var all = new List<int>();
            foreach (var part in _triangles) all.AddRange(part);
            return all.ToArray();
        }
        set
        {
            _triangles.Clear();
            _triangles.Add(Checked(value));
            MeasureBounds();
        }
    }

    /// <summary>Whether scripts may still read and change the content of the mesh.</summary>
    internal bool IsReadable { get; private set; } = true;

    public void SetVertices(List<Vector3> inVertices) => vertices = inVertices.ToArray();
    public void SetVertices(Vector3[] inVertices) => vertices = inVertices;
    public void SetVertices(Vector3[] inVertices, int start, int length) => vertices = inVertices.AsSpan(start, length).ToArray();
    public void SetNormals(List<Vector3> inNormals) => normals = inNormals.ToArray();
    public void SetNormals(Vector3[] inNormals) => normals = inNormals;
    public void SetNormals(Vector3[] inNormals, int start, int length) => normals = inNormals.AsSpan(start, length).ToArray();
    public void SetTriangles(List<int> triangles, int submesh) => SetTriangles(triangles.ToArray(), submesh);
    public void SetTriangles(int[] triangles, int submesh) => SetTriangles(triangles, submesh, calculateBounds: true);

    public void SetTriangles(int[] triangles, int submesh, bool calculateBounds) =>
        SetTriangles(triangles, 0, triangles.Length, submesh, calculateBounds);

    /// <summary>Sets the triangles. Does not allocate if the number of indices does not change.</summary>
    public void SetTriangles(int[] triangles, int trianglesStart, int trianglesLength, int submesh, bool calculateBounds = true, int baseVertex = 0)
    {
        ThrowIfDestroyed();
        ThrowIfUploaded();
        if (_triangles[submesh].Length != trianglesLength) _triangles[submesh] = new int[trianglesLength];
        var part = _triangles[submesh];
        for (var i = 0; i < part.Length; i++) part[i] = triangles[trianglesStart + i] + baseVertex;
        Check(part);
        if (calculateBounds) MeasureBounds();
    }

    public void MarkDynamic() { }

    public void UploadMeshData(bool markNoLongerReadable) => IsReadable = IsReadable && !markNoLongerReadable;

    static T[] Copy<T>(T[] values) => (T[])values?.Clone() ?? Array.Empty<T>();

    void MeasureBounds()
    {
        var box = vertexCount == 0 ? default : new Bounds(_vertices[0], Vector3.zero);
        foreach (var vertex in _vertices) box.Encapsulate(vertex);
        bounds = box;
    }

    int[] Checked(int[] triangles)
    {
        Check(triangles);
        return Copy(triangles);
    }

    void ThrowIfUploaded()
    {
        if (!IsReadable) throw new InvalidOperationException("Not allowed to access a mesh that was uploaded and is no longer readable.");
    }

    void Check(int[] triangles)
    {
        if (triangles.Length % 3 != 0)
        {
            throw new ArgumentException("The number of supplied triangle indices must be a multiple of 3.", nameof(triangles));
        }

        foreach (var index in triangles)
        {
            if (index < 0 || index >= vertexCount)
            {
                throw new ArgumentException($"Index {index} is out of the {vertexCount} vertices.", nameof(triangles));
            }
        }
    }
}

public sealed class MeshFilter : Component
{
    [field: SerializeField, SerializedName("m_Mesh")] public Mesh sharedMesh { get; set; }
}

public class MeshRenderer : Renderer
{
}
