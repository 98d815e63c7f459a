using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class MaterialPropertyBlock
{
    readonly MaterialProperties<float> _floats = new();

    public void Clear() => _floats.Clear();

    public bool HasFloat(int nameID) => _floats.Has(nameID);
    public bool HasFloat(string name) => HasFloat(Shader.PropertyToID(name));
    public float GetFloat(int nameID) => _floats.Get(nameID);
    public float GetFloat(string name) => GetFloat(Shader.PropertyToID(name));
    public void SetFloat(int nameID, float value) => _floats.Set(nameID, value);
    public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);

    internal void CopyFrom(MaterialPropertyBlock other)
    {
        if (other == null) Clear();
        else _floats.CopyFrom(other._floats);
    }
}
