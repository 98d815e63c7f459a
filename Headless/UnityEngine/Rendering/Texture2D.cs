namespace UnityEngine;

public sealed class Texture2D : Texture
{
    Color32[] _pixels;

    public Texture2D(int width, int height)
    {
        this.width = width;
        this.height = height;
        _pixels = new Color32[width * height];
    }

    public Color GetPixel(int x, int y) => _pixels[x + y * width];
    public void SetPixel(int x, int y, Color color) => _pixels[x + y * width] = color;
    public Color32[] GetPixels32() => (Color32[])_pixels.Clone();
    public void SetPixels32(Color32[] colors) => _pixels = (Color32[])colors.Clone();
    public void Apply() { }
    public void Apply(bool updateMipmaps) { }
    public void Apply(bool updateMipmaps, bool makeNoLongerReadable) { }
}
