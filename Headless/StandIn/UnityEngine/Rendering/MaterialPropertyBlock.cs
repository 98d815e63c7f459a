using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class MaterialPropertyBlock
{
    readonly MaterialProperties<float> _floats = new();
    readonly MaterialProperties<Vector4> _vectors = new();
    readonly MaterialProperties<Texture> _textures = new();

    public bool isEmpty => _floats.Count == 0 && _vectors.Count == 0 && _textures.Count == 0;

    public void Clear()
    {
        _floats.Clear();
        _vectors.Clear();
        _textures.Clear();
    }

    public bool HasFloat(int nameID) => _floats.Has(nameID);
    public bool HasFloat(string name) => HasFloat(Shader.PropertyToID(name));
    public float GetFloat(int nameID) => _floats.Get(nameID);
    public float GetFloat(string name) => GetFloat(Shader.PropertyToID(name));
    public void SetFloat(int nameID, float value) => _floats.Set(nameID, value);
    public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);
    public bool HasColor(int nameID) => _vectors.Has(nameID);
    public Color GetColor(int nameID) => _vectors.Get(nameID);
    public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));
    public void SetColor(int nameID, Color value) => _vectors.Set(nameID, value);
    public Texture GetTexture(string name) => _textures.Get(Shader.PropertyToID(name));

    public void SetTexture(int nameID, Texture value)
    {
        if (!value) throw new System.ArgumentNullException(nameof(value));
        _textures.Set(nameID, value);
    }

    internal void CopyFrom(MaterialPropertyBlock other)
    {
        if (other == null)
        {
            Clear();
            return;
        }
        _floats.CopyFrom(other._floats);
        _vectors.CopyFrom(other._vectors);
        _textures.CopyFrom(other._textures);
    }
}
