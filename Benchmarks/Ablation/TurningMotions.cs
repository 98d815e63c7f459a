namespace Nowpose.Benchmarks.Ablation;

/// <summary>
/// Creates motions that a predictor has not seen before: objects that rest or move along a line for seconds, then start, turn or stop, at once or gently. The
/// weights of a mixture then result from a line, on which all forecasters are right, or from noise.
/// </summary>
static class TurningMotions
{
    const double Seconds = ObjectMotion.Seconds, Row = 1 / ObjectMotion.RowsPerSecond;

    /// <summary>Integration steps per row.</summary>
    const int Steps = 10;

    /// <summary>Noise of a good tracker: m and rad.</summary>
    const double Noise = 0.5e-3, AngleNoise = 2e-3;

    public static IReadOnlyList<ObjectMotion> All(int seed) =>
    [
        .. new[] { double.PositiveInfinity, 2, 0.5 }.SelectMany((ramp, i) => Turning(seed + 10 * i, ramp)),
        new("tracker, at rest", _ => default, Noise, AngleNoise),
        new("tracker at rest, coarse", _ => default, 2e-3, 0.02),
        new("tracker, first turns", Driven(seed + 50, _ => 0.6, Changes(seed + 51, 0.8, 3, 8), 2), Noise, AngleNoise),
        new("tracker, first start", Driven(seed + 52, Changes(seed + 53, 0.6, 3, 8), _ => 0, 2), Noise, AngleNoise),
    ];

    /// <inheritdoc cref="Driven" path="/param[@name='ramp']"/>
    static IEnumerable<ObjectMotion> Turning(int seed, double ramp)
    {
        var name = double.IsFinite(ramp) ? FormattableString.Invariant($", {ramp:0.0} per s") : ", at once";
        var speeds = Changes(seed + 3, 0.3, 2, 6);
        yield return new("first turns" + name, Driven(seed, _ => 0.6, Changes(seed, 0.8, 3, 8), ramp));
        yield return new("turns in place" + name, Driven(seed + 1, _ => 0, Changes(seed + 1, 1, 2, 6), ramp));
        yield return new("conveyor" + name, Driven(seed + 2, Changes(seed + 2, 0.4, 2, 8), _ => 0, ramp));
        yield return new("conveyor, two speeds" + name, Driven(seed + 3, t => 0.2 + speeds(t), _ => 0, ramp));
        yield return new("vehicle" + name, Driven(seed + 4, Changes(seed + 4, 0.7, 1, 6), Changes(seed + 5, 0.6, 1, 6), ramp));
    }

    /// <summary>A speed that alternates between 0 and a random share of its maximum in either direction.</summary>
    /// <param name="min">Minimum time between two changes, s.</param>
    /// <param name="max">Maximum time between two changes, s.</param>
    static Func<double, double> Changes(int seed, double speed, double min, double max)
    {
        var random = new Random(seed);
        var changes = new List<(double Time, double Speed)> { (0, 0) };
        while (changes[^1].Time < Seconds)
            changes.Add((changes[^1].Time + min + (max - min) * random.NextDouble(),
                changes.Count % 2 == 0 ? 0 : speed * (0.4 + 0.6 * random.NextDouble()) * (random.Next(3) == 0 ? -1 : 1)));
        return t => changes.FindLast(change => change.Time <= t).Speed;
    }

    /// <summary>An object that moves in the direction of its heading and turns.</summary>
    /// <param name="phase">Shifts the changes against the samples.</param>
    /// <param name="speed">Commanded speed, m/s, at a time in s.</param>
    /// <param name="rate">Commanded yaw rate, rad/s.</param>
    /// <param name="ramp">Maximum change of both speeds per second: m/s² and rad/s².</param>
    static Func<double, ObjectPose> Driven(int phase, Func<double, double> speed, Func<double, double> rate, double ramp)
    {
        var poses = new ObjectPose[ObjectMotion.Rows];
        var (shift, step) = (new Random(phase).NextDouble() * 0.1, Row / Steps);
        var (x, y, angle, v, w) = (0.0, 0.0, 0.0, speed(shift), rate(shift));
        for (var row = 1; row < poses.Length; row++)
        {
            for (var i = 0; i < Steps; i++)
            {
                var time = shift + (row - 1) * Row + i * step;
                v += Math.Clamp(speed(time) - v, -ramp * step, ramp * step);
                w += Math.Clamp(rate(time) - w, -ramp * step, ramp * step);
                angle += w * step;
                (x, y) = (x + v * step * Math.Cos(angle - w * step / 2), y + v * step * Math.Sin(angle - w * step / 2));
            }

            poses[row] = new ObjectPose(x, y, angle);
        }

        return ObjectMotion.Through(poses);
    }
}
