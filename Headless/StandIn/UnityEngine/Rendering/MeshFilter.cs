using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class MeshFilter : Component
{
    [field: SerializeField, SerializedName("m_Mesh")] public Mesh sharedMesh { get; set; }
}
