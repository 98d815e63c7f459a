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
}
