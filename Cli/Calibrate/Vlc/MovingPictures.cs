using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Rejects pictures that were taken while the headset moved. L_visu is measured with a still headset.</summary>
/// <remarks>
/// A display corrects its frames for head motion, so both codes shift and smear in such a picture. A picture counts as moving when the
/// control's code moves with nearly the same velocity from the previous picture and to the next one, in the order of control time. A camera
/// that was relocated moves only once, and one that shakes moves back.
/// </remarks>
static class MovingPictures
{
    public const string Fault = PictureFaults.Moved;

    /// <summary>Speed range of a motion, in sides of the control's code per second. A hand-held camera is slower, a relocated one faster.</summary>
    const double MinSpeed = 0.5, MaxSpeed = 20;

    /// <summary>Maximum difference of the velocities before and after a picture, relative to the larger one.</summary>
    const double MaxDifference = 0.7;

    /// <summary>Maximum interval between pictures for a valid velocity, ms.</summary>
    const double MaxIntervalMs = 500;

    /// <summary>Maximum share of the read pictures that may be moving. Above it, the series was not taken with a still headset.</summary>
    const double MaxShare = 0.5;

    /// <summary>Returns the same pictures in the same order. Rejects those taken in motion, and all of them if most were.</summary>
    /// <param name="refusal">The reason why all are rejected; null if they are not.</param>
    public static IReadOnlyList<PictureResult> Rejected(IReadOnlyList<PictureResult> pictures, out string refusal)
    {
        var read = TimeOrder.Of(pictures.Where(picture => picture.Places != null)).Pictures;
        var moving = Enumerable.Range(1, Math.Max(0, read.Count - 2))
            .Where(i => IsMoving(VelocityOf(read[i - 1], read[i]), VelocityOf(read[i], read[i + 1]))).Select(i => read[i].Picture).ToHashSet();
        refusal = moving.Count > MaxShare * read.Count
            ? VlcMessages.MovedPictures(moving.Count, read.Count)
            : null;
        var areAll = refusal != null;
        return [.. pictures.Select(picture => moving.Contains(picture) || areAll && picture.IsRead ? PictureResult.Not(picture.File, Fault) : picture)];
    }

    static bool IsMoving((double X, double Y) before, (double X, double Y) after) =>
        IsMotion(before) && IsMotion(after)
        && Length((after.X - before.X, after.Y - before.Y)) <= MaxDifference * Math.Max(Length(before), Length(after));

    static bool IsMotion((double X, double Y) velocity) => Length(velocity) is > MinSpeed and < MaxSpeed;

    static double Length((double X, double Y) velocity) => Math.Sqrt(velocity.X * velocity.X + velocity.Y * velocity.Y);

    /// <returns>Sides per second; 0 if unknown.</returns>
    static (double X, double Y) VelocityOf((PictureResult Picture, double Ms) from, (PictureResult Picture, double Ms) to)
    {
        var ms = to.Ms - from.Ms;
        if (ms <= 0 || ms > MaxIntervalMs) return default;
        CodePlaces before = from.Picture.Places, after = to.Picture.Places;
        // Uses the same scale for both directions of time.
        var scale = 2000 / (ms * (before.ControlSide + after.ControlSide));
        return (scale * (after.Control.X - before.Control.X), scale * (after.Control.Y - before.Control.Y));
    }
}
