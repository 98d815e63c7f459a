using System.Text.Json;

namespace Nowpose.Vision;

/// <summary>A request to a worker process to analyse or render a picture.</summary>
public sealed class PictureRequest
{
    static readonly JsonSerializerOptions Options = new() { PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    readonly object _message;

    PictureRequest(object message) => _message = message;

    /// <param name="path">Path of a PNG or JPEG file.</param>
    public static PictureRequest File(string path) => new(new { file = Path.GetFullPath(path) });

    /// <param name="bytes">Grey values, row by row.</param>
    public static PictureRequest Grey(int width, int height, byte[] bytes) => new(new { grey = new { width, height, data = Convert.ToBase64String(bytes) } });

    /// <summary>Creates a request to render a picture and analyse it in memory.</summary>
    public static PictureRequest Made(Shot shot) => new(new { shot });

    /// <summary>Creates a request to render a picture and write it to a file.</summary>
    /// <param name="path">Path with the extension .png or .jpg.</param>
    public static PictureRequest Made(Shot shot, string path) => new(new { shot, to = Path.GetFullPath(path) });

    /// <summary>Creates a request to track patches in a picture.</summary>
    /// <param name="boxes">The patches in this picture; null to continue tracking the previous ones.</param>
    internal static PictureRequest Tracked(int width, int height, byte[] bytes, IReadOnlyList<PictureBox> boxes) =>
        new(new { grey = new { width, height, data = Convert.ToBase64String(bytes) }, track = boxes == null ? (object)new { } : new { boxes } });

    internal string Json() => JsonSerializer.Serialize(_message, Options);
}
