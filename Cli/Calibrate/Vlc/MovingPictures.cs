namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Rejects pictures that were taken while the headset moved. L_visu is measured with a still headset.</summary>
/// <remarks>
/// A display corrects its frames for head motion, so both codes shift and smear in such a picture. A picture counts as moving when the
/// control's code moves both from the picture before and to the picture after. A camera that was relocated moves only once, and one that
/// shakes moves back.
/// </remarks>
static class MovingPictures
{
    public const string Fault = "taken while the headset moved";

    /// <summary>Speed range of a motion, in sides of the control's code per second. A hand-held camera is slower, a relocated one faster.</summary>
    const double MinSpeed = 0.5, MaxSpeed = 20;

    /// <summary>Maximum interval between pictures for a valid speed, ms.</summary>
    const double MaxIntervalMs = 500;

    /// <summary>Maximum share of the read pictures that may be moving. Above it, the series was not taken with a still headset.</summary>
    const double MaxShare = 0.5;

    /// <summary>Returns the same pictures in the same order, with those taken in motion rejected.</summary>
    /// <exception cref="InputException">Most of the pictures were taken in motion.</exception>
    public static IReadOnlyList<PictureResult> Rejected(IReadOnlyList<PictureResult> pictures)
    {
        PictureResult[] read = [.. pictures.Where(picture => picture.IsRead && picture.Places != null)];
        var moving = Enumerable.Range(1, Math.Max(0, read.Length - 2))
            .Where(i => IsMoving(VelocityOf(read[i - 1], read[i]), VelocityOf(read[i], read[i + 1]))).Select(i => read[i]).ToHashSet();
        if (moving.Count > MaxShare * read.Length)
            throw new InputException($"{moving.Count} of {read.Length} pictures were taken while the headset or the camera moved; "
                + "L_visu is measured with a still head: put headset and camera on a stand. Pictures of a moving headset are for 'calibrate head'");
        return [.. pictures.Select(picture => moving.Contains(picture) ? PictureResult.Not(picture.File, Fault) : picture)];
    }

    static bool IsMoving((double X, double Y) before, (double X, double Y) after) =>
        IsMotion(before) && IsMotion(after) && before.X * after.X + before.Y * after.Y > 0;

    static bool IsMotion((double X, double Y) velocity) => Math.Sqrt(velocity.X * velocity.X + velocity.Y * velocity.Y) is > MinSpeed and < MaxSpeed;

    /// <returns>Sides per second; 0 if unknown.</returns>
    static (double X, double Y) VelocityOf(PictureResult from, PictureResult to)
    {
        var ms = PictureResult.IntervalMs(from, to);
        if (ms <= 0 || ms > MaxIntervalMs) return default;
        var scale = 1000 / (ms * from.Places.ControlSide);
        return (scale * (to.Places.Control.X - from.Places.Control.X), scale * (to.Places.Control.Y - from.Places.Control.Y));
    }
}
