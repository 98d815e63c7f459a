using UnityEngine.Rendering;

namespace UnityEngine;

public class Material : Object
{
    readonly MaterialProperties<float> _floats = new();
    readonly MaterialProperties<Vector4> _vectors = new();

    public Material(Shader shader) => this.shader = shader;

    public Shader shader { get; set; }

    /// <summary>Render queue of the material. If the value was set to −1, the getter returns the queue of the shader.</summary>
    public int renderQueue
    {
        get => OwnRenderQueue >= 0 || !shader ? OwnRenderQueue : shader.renderQueue;
        set => OwnRenderQueue = value;
    }

    internal int OwnRenderQueue { get; set; } = -1;

    public bool enableInstancing { get; set; }

    public Color color
    {
        get => GetColor("_Color");
        set => SetColor("_Color", value);
    }

    public Texture mainTexture { get; set; }

    public string GetTag(string tag, bool searchFallbacks, string defaultValue) =>
        shader && shader.Tags.TryGetValue(tag, out var value) ? value : defaultValue;

    public bool HasProperty(int nameID) => _floats.Has(nameID) || _vectors.Has(nameID);
    public bool HasProperty(string name) => HasProperty(Shader.PropertyToID(name));
    public float GetFloat(int nameID) => _floats.Get(nameID);
    public float GetFloat(string name) => GetFloat(Shader.PropertyToID(name));
    public void SetFloat(int nameID, float value) => _floats.Set(nameID, value);
    public void SetFloat(string name, float value) => SetFloat(Shader.PropertyToID(name), value);
    public Color GetColor(int nameID) => _vectors.Get(nameID);
    public Color GetColor(string name) => GetColor(Shader.PropertyToID(name));
    public void SetColor(int nameID, Color value) => _vectors.Set(nameID, value);
    public void SetColor(string name, Color value) => SetColor(Shader.PropertyToID(name), value);
}
