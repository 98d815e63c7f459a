using System;
using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class MeshFilter : Component
{
    const string Copied = " Instance";

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
            else if (!_mesh.name.EndsWith(Copied, StringComparison.Ordinal)) Copy();
            return _mesh;
        }
        set => _mesh = value;
    }

    void Copy()
    {
        var name = _mesh.name + Copied;
        _mesh = (Mesh)_mesh.Duplicate();
        _mesh.name = name;
    }
}
