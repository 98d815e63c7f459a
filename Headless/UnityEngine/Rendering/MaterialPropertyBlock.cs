using UnityEngine.Rendering;

namespace UnityEngine;

public sealed class MaterialPropertyBlock
{
    readonly MaterialProperties<float> _floats = new();
    readonly MaterialProperties<Vector4> _vectors = new();
    readonly MaterialProperties<Texture> _textures = new();

    public bool isEmpty => _floats.Count + _vectors.Count + _textures.Count == 0;

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
    public bool HasColor(string name) => HasColor(Shader.PropertyToID(name));
    public Color GetColor(int nameID) => _vectors.Get(nameID);
    public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));
    public void SetColor(int nameID, Color value) => _vectors.Set(nameID, value);
    public void SetColor(string name, Color value) => SetColor(Shader.PropertyToID(name), value);
    public Vector4 GetVector(int nameID) => _vectors.Get(nameID);
    public Vector4 GetVector(string name) => GetVector(Shader.PropertyToID(name));
    public void SetVector(int nameID, Vector4 value) => _vectors.Set(nameID, value);
    public void SetVector(string name, Vector4 value) => SetVector(Shader.PropertyToID(name), value);
    public Texture GetTexture(int nameID) => _textures.Get(nameID);
    public void SetTexture(int nameID, Texture value) => _textures.Set(nameID, value);

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
