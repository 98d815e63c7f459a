using System.CommandLine;
using System.Globalization;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Creates options whose value is a rectangle in a picture: X,Y,WIDTH,HEIGHT in pixels.</summary>
static class BoxOption
{
    const int MinSide = 8, MaxValue = 10_000;

    public static Option<PictureBox?> Create(string name, string description) => new(name)
    {
        Description = $"{description}: X,Y,WIDTH,HEIGHT in px [sides {MinSide} px or more]",
        CustomParser = result =>
        {
            var text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
            int[] numbers = [.. text.Split(',').Select(word => int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out var number) ? number : -1)];
            if (numbers.Length == 4 && numbers.All(number => number is >= 0 and <= MaxValue) && numbers[2] >= MinSide && numbers[3] >= MinSide)
                return new PictureBox(numbers[0], numbers[1], numbers[2], numbers[3]);
            result.AddError(OptionValueMessages.NotABox(name, text, MinSide, MaxValue));
            return null;
        },
    };
}
