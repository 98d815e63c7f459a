using System;

namespace UnityEngine;

public sealed class LineRenderer : Renderer
{
    Vector3[] _positions = Array.Empty<Vector3>();

    public bool useWorldSpace { get; set; } = true;
    public bool loop { get; set; }
    public float startWidth { get; set; } = 1;
    public float endWidth { get; set; } = 1;
    public Color startColor { get; set; } = Color.white;
    public Color endColor { get; set; } = Color.white;
    public float widthMultiplier { get; set; } = 1;

    public int positionCount
    {
        get => _positions.Length;
        set => Array.Resize(ref _positions, value);
    }

    public Vector3 GetPosition(int index) => _positions[index];
    public void SetPosition(int index, Vector3 position) => _positions[index] = position;

    public void SetPositions(Vector3[] positions)
    {
        for (var i = 0; i < Math.Min(positions.Length, positionCount); i++) _positions[i] = positions[i];
    }
}
