using System.Text.Json;

namespace Nowpose.Vision;

/// <summary>Tracks patches of a video's first picture in the following pictures. Not thread-safe.</summary>
public sealed class MotionTracker : IDisposable
{
    readonly VisionWorker _worker = KeptWorkers.Take() ?? new VisionWorker();
    readonly IReadOnlyList<PictureBox> _boxes;
    bool _hasBegun;

    /// <param name="boxes">The patches. They must be completely within the first picture.</param>
    /// <exception cref="InputException">Node.js is not installed, or was not installed when this program was built.</exception>
    public MotionTracker(IReadOnlyList<PictureBox> boxes) => _boxes = boxes;

    /// <summary>Returns the positions of the patches in the next picture.</summary>
    /// <param name="bytes">Grey values, row by row.</param>
    /// <exception cref="InvalidOperationException">The picture is invalid.</exception>
    public IReadOnlyList<TrackedPlace> Follow(int width, int height, byte[] bytes)
    {
        var answer = _worker.Ask(PictureRequest.Tracked(width, height, bytes, _hasBegun ? null : _boxes).Json());
        _hasBegun = true;
        if (answer.TryGetProperty("error", out var error)) throw new InvalidOperationException(error.GetString());
        return [.. answer.GetProperty("places").EnumerateArray().Select(PlaceOf)];
    }

    public void Dispose() => KeptWorkers.Keep(_worker);

    static TrackedPlace PlaceOf(JsonElement place) =>
        new(place.GetProperty("x").GetDouble(), place.GetProperty("y").GetDouble(), place.GetProperty("score").GetDouble());
}
