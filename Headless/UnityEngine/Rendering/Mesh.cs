using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

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
            _vertices = Copy(value);
            MeasureBounds();
        }
    }

    public Vector3[] normals
    {
        get => Copy(_normals);
        set => _normals = Copy(value);
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
            MeasureBounds();
        }
    }

    public void SetVertices(List<Vector3> inVertices) => vertices = inVertices.ToArray();
    public void SetVertices(Vector3[] inVertices) => vertices = inVertices;
    public void SetNormals(List<Vector3> inNormals) => normals = inNormals.ToArray();
    public void SetNormals(Vector3[] inNormals) => normals = inNormals;
    public void SetTriangles(List<int> triangles, int submesh) => SetTriangles(triangles.ToArray(), submesh);

    public void SetTriangles(int[] triangles, int submesh)
    {
        _triangles[submesh] = Checked(triangles);
        MeasureBounds();
    }

    internal override Object Duplicate()
    {
        var copy = new Mesh
        {
            indexFormat = indexFormat,
            vertices = _vertices,
            normals = _normals,
        };
        copy._triangles.Clear();
        copy._triangles.AddRange(_triangles);
        return copy;
    }

    static T[] Copy<T>(T[] values) => (T[])values?.Clone() ?? Array.Empty<T>();

    void MeasureBounds()
    {
        var box = vertexCount == 0 ? default : new Bounds(_vertices[0], Vector3.zero);
        foreach (var vertex in _vertices) box.Encapsulate(vertex);
        bounds = box;
    }

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
