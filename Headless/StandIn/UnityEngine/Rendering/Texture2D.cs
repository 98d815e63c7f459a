namespace UnityEngine;

public sealed class Texture2D : Texture
{
    /// <summary>Without pixels: nothing looks at them.</summary>
    public Texture2D(int width, int height) { }

    public void Apply() { }
}
