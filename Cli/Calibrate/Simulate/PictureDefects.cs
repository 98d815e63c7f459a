using Nowpose.Cli.Replay;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>
/// Adds a defect to a picture: an object in front of a code, a reflection on it, overexposed LEDs, a shaken camera, or a code that is
/// partly outside.
/// </summary>
static class PictureDefects
{
    static readonly (string Name, Func<Shot, RandomStream, Shot> AddTo)[] Kinds =
        [("covered", Covered), ("glare", Dazzled), ("smeared", Smeared), ("cut off", CutOff), ("overexposed", Overexposed)];

    /// <summary>Linear light of red, green and white LEDs in the red, green and blue channels of a camera.</summary>
    static readonly double[][] LedColours = [[1, 0.07, 0.03], [0.15, 1, 0.25], [1, 0.95, 0.9]];

    public static Shot AddRandom(Shot shot, RandomStream random, out string name)
    {
        var kind = Kinds[(int)(random.Next() * Kinds.Length)];
        name = kind.Name;
        return kind.AddTo(shot, random);
    }

    static Shot Covered(Shot shot, RandomStream random)
    {
        var (left, top, size) = BoundsOf(AnyCode(shot, random));
        double Part() => size * (0.15 + 0.6 * random.Next());
        return shot with { Covers = [new Cover([left + size * random.Next() - Part() / 2, top + size * random.Next() - Part() / 2, Part(), Part()], 0.02 + 0.6 * random.Next())] };
    }

    static Shot Dazzled(Shot shot, RandomStream random)
    {
        var (left, top, size) = BoundsOf(AnyCode(shot, random));
        return shot with { Glares = [new Glare(left + size * random.Next(), top + size * random.Next(), size * (0.15 + 0.7 * random.Next()), 0.3 + 2 * random.Next())] };
    }

    static Shot Smeared(Shot shot, RandomStream random)
    {
        double angle = 2 * Math.PI * random.Next(), length = 4 + 24 * random.Next();
        return shot with { Motion = [length * Math.Cos(angle), length * Math.Sin(angle)] };
    }

    static Shot CutOff(Shot shot, RandomStream random)
    {
        var code = AnyCode(shot, random);
        var (left, _, size) = BoundsOf(code);
        // Moves all codes so that the left or right edge of the picture cuts off a part of the selected code.
        var cut = size * (0.1 + 0.6 * random.Next());
        var by = left < shot.Width / 2 ? -left - cut : shot.Width - left - size + cut;
        return shot with { Codes = [.. shot.Codes.Select(each => each with { Corners = [.. each.Corners.Select(corner => new[] { corner[0] + by, corner[1] })] })] };
    }

    static Shot Overexposed(Shot shot, RandomStream random)
    {
        var leds = shot.Codes[0] with { Light = 1.5 + 4.5 * random.Next(), Colour = LedColours[(int)(random.Next() * LedColours.Length)] };
        return shot with { Codes = [leds, .. shot.Codes.Skip(1)] };
    }

    static DrawnCode AnyCode(Shot shot, RandomStream random) => shot.Codes[(int)(random.Next() * shot.Codes.Count)];

    static (double Left, double Top, double Size) BoundsOf(DrawnCode code)
    {
        double left = code.Corners.Min(corner => corner[0]), top = code.Corners.Min(corner => corner[1]);
        return (left, top, Math.Max(code.Corners.Max(corner => corner[0]) - left, code.Corners.Max(corner => corner[1]) - top));
    }
}
