namespace UnityEngine;

public sealed class Texture2D : Texture
{
    /// <summary>Has no pixels, because nothing reads them.</summary>
    public Texture2D(int width, int height) { }

    public void Apply() { }
}
