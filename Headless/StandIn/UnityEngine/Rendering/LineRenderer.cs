using UnityEngine.Serialization;

namespace UnityEngine;

public sealed class LineRenderer : Renderer
{
    [field: SerializeField, SerializedName("m_UseWorldSpace")] public bool useWorldSpace { get; set; } = true;

    Vector3[] _positions = new Vector3[2];

    public float widthMultiplier { get; set; } = 1;

    public int positionCount { get; set; }

    public void SetPosition(int index, Vector3 position)
    {
        ThrowIfDestroyed();
        if (index < 0 || index >= positionCount) throw new System.IndexOutOfRangeException();
        if (_positions.Length < positionCount) System.Array.Resize(ref _positions, positionCount);
        _positions[index] = position;
    }

    public Vector3 GetPosition(int index)
    {
        ThrowIfDestroyed();
        return _positions[index];
    }
}
