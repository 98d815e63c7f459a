using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class Mesh : Object
{
    readonly List<int[]> _triangles = new() { Array.Empty<int>() };
    Vector3[] _vertices = Array.Empty<Vector3>();
    Vector3[] _normals = Array.Empty<Vector3>();
    Vector2[] _uv = Array.Empty<Vector2>();
    Color32[] _colors32 = Array.Empty<Color32>();

    public IndexFormat indexFormat { get; set; }
    public Bounds bounds { get; set; }
    public bool isReadable => true;
    public int vertexCount => _vertices.Length;

    public Vector3[] vertices
    {
        get => Copy(_vertices);
        set
        {
            _vertices = Copy(value);
            RecalculateBounds();
        }
    }

    public Vector3[] normals
    {
        get => Copy(_normals);
        set => _normals = Copy(value);
    }

    public Vector2[] uv
    {
        get => Copy(_uv);
        set => _uv = Copy(value);
    }

    public Color32[] colors32
    {
        get => Copy(_colors32);
        set => _colors32 = Copy(value);
    }

    /// <summary>Of all parts; three indices each, clockwise seen from outside.</summary>
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
            RecalculateBounds();
        }
    }

    public int subMeshCount
    {
        get => _triangles.Count;
        set
        {
            while (_triangles.Count > value) _triangles.RemoveAt(_triangles.Count - 1);
            while (_triangles.Count < value) _triangles.Add(Array.Empty<int>());
        }
    }

    public void Clear()
    {
        _vertices = _normals = Array.Empty<Vector3>();
        _uv = Array.Empty<Vector2>();
        _colors32 = Array.Empty<Color32>();
        subMeshCount = 0;
        subMeshCount = 1;
        bounds = default;
    }

    public void SetVertices(List<Vector3> inVertices) => vertices = inVertices.ToArray();
    public void SetVertices(Vector3[] inVertices) => vertices = inVertices;
    public void SetNormals(List<Vector3> inNormals) => normals = inNormals.ToArray();
    public void SetNormals(Vector3[] inNormals) => normals = inNormals;
    public void SetUVs(int channel, List<Vector2> uvs) => uv = uvs.ToArray();
    public int[] GetTriangles(int submesh) => Copy(_triangles[submesh]);
    public void SetTriangles(List<int> triangles, int submesh) => SetTriangles(triangles.ToArray(), submesh);

    public void SetTriangles(int[] triangles, int submesh)
    {
        _triangles[submesh] = Checked(triangles);
        RecalculateBounds();
    }

    public void RecalculateBounds()
    {
        var box = vertexCount == 0 ? default : new Bounds(_vertices[0], Vector3.zero);
        foreach (var vertex in _vertices) box.Encapsulate(vertex);
        bounds = box;
    }

    /// <summary>The mean of the faces around each vertex, weighted by their area.</summary>
    public void RecalculateNormals()
    {
        var sums = new Vector3[vertexCount];
        foreach (var part in _triangles)
        {
            for (var i = 0; i + 2 < part.Length; i += 3)
            {
                var face = Vector3.Cross(_vertices[part[i + 1]] - _vertices[part[i]], _vertices[part[i + 2]] - _vertices[part[i]]);
                for (var k = 0; k < 3; k++) sums[part[i + k]] += face;
            }
        }

        // Faces of a millimetre have areas below what Vector3.normalized takes for nothing.
        for (var i = 0; i < sums.Length; i++) sums[i] = sums[i].magnitude > 0 ? sums[i] / sums[i].magnitude : Vector3.zero;
        _normals = sums;
    }

    public void RecalculateTangents() { }

    public void UploadMeshData(bool markNoLongerReadable) { }

    internal override Object Duplicate()
    {
        var copy = new Mesh
        {
            indexFormat = indexFormat,
            vertices = _vertices,
            normals = _normals,
            uv = _uv,
            colors32 = _colors32,
            subMeshCount = subMeshCount,
        };
        for (var i = 0; i < subMeshCount; i++) copy.SetTriangles(_triangles[i], i);
        return copy;
    }

    static T[] Copy<T>(T[] values) => (T[])values?.Clone() ?? Array.Empty<T>();

    int[] Checked(int[] triangles)
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

        return Copy(triangles);
    }
}
