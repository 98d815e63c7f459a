using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Rejects pictures that were taken while the headset moved. L_visu must be measured with a still headset.</summary>
/// <remarks>
/// A display corrects its frames for head motion, so both codes shift and blur in such a picture. A picture was taken in motion if the
/// velocity of the control code from the previous picture is nearly the same as to the next picture, in the order of control time.
/// A relocated camera moves only once, and a shaking camera moves back, so neither is rejected.
/// </remarks>
static class MovingPictures
{
    public const string Fault = PictureFaults.Moved;

    /// <summary>
    /// Speed range of head motion, in sides of the control code per second. A shaking camera is slower, a relocated one is faster.
    /// </summary>
    const double MinSpeed = 0.5, MaxSpeed = 20;

    /// <summary>Maximum difference between the velocities before and after a picture, relative to the larger one.</summary>
    const double MaxDifference = 0.7;

    /// <summary>Maximum interval between two pictures from which a velocity is computed, ms.</summary>
    const double MaxIntervalMs = 500;

    /// <summary>Maximum share of pictures in motion. Above it, the whole series is rejected.</summary>
    const double MaxShare = 0.5;

    /// <summary>
    /// Returns the pictures in the same order. Marks those taken in motion as rejected, or all if most of them were taken in motion.
    /// </summary>
    /// <param name="refusal">The reason why all pictures are rejected; null if they are not.</param>
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

    /// <returns>Velocity in sides of the control code per second; 0 if unknown.</returns>
    static (double X, double Y) VelocityOf((PictureResult Picture, double Ms) from, (PictureResult Picture, double Ms) to)
    {
        var ms = to.Ms - from.Ms;
        if (ms <= 0 || ms > MaxIntervalMs) return default;
        CodePlaces before = from.Picture.Places, after = to.Picture.Places;
        // Divides by the mean side, so that the reverse movement has the same velocity with the opposite sign.
        var scale = 2000 / (ms * (before.ControlSide + after.ControlSide));
        return (scale * (after.Control.X - before.Control.X), scale * (after.Control.Y - before.Control.Y));
    }
}
