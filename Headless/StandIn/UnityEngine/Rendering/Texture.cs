namespace UnityEngine;

public class Texture : Object
{
    protected Texture() { }
}

public sealed class Texture2D : Texture
{
    /// <summary>Creates a texture. The stand-in stores no pixels, because nothing reads them.</summary>
    public Texture2D(int width, int height) { }

    public void Apply() { }
}
