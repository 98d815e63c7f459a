using System.Text.Json;

namespace Nowpose.Vision;

/// <summary>A request to a worker to analyse or create a picture.</summary>
public sealed class PictureRequest
{
    static readonly JsonSerializerOptions Options = new() { PropertyNamingPolicy = JsonNamingPolicy.CamelCase };

    readonly object _message;

    PictureRequest(object message) => _message = message;

    /// <param name="path">A PNG or JPEG file.</param>
    public static PictureRequest File(string path) => new(new { file = Path.GetFullPath(path) });

    /// <param name="bytes">Grey, row by row.</param>
    public static PictureRequest Grey(int width, int height, byte[] bytes) => new(new { grey = new { width, height, data = Convert.ToBase64String(bytes) } });

    /// <summary>Requests a picture that is created and analysed without a file.</summary>
    public static PictureRequest Made(Shot shot) => new(new { shot });

    /// <summary>Requests a picture that is created and stored.</summary>
    /// <param name="path">Ends with .png or .jpg.</param>
    public static PictureRequest Made(Shot shot, string path) => new(new { shot, to = Path.GetFullPath(path) });

    /// <summary>Requests the tracking of patches in a picture.</summary>
    /// <param name="boxes">The patches in this picture; null to continue with the previous ones.</param>
    internal static PictureRequest Tracked(int width, int height, byte[] bytes, IReadOnlyList<PictureBox> boxes) =>
        new(new { grey = new { width, height, data = Convert.ToBase64String(bytes) }, track = boxes == null ? (object)new { } : new { boxes } });

    internal string Json() => JsonSerializer.Serialize(_message, Options);
}
