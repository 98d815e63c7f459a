using System.Globalization;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Tests.Common;

/// <summary>Reads the numbers of a message whose numbers are not known in advance, for example measured values.</summary>
static partial class MessageNumbers
{
    /// <summary>Finds a message in a text and returns its numbers in the order of the text. Fails if the text does not contain the message.</summary>
    /// <param name="message">Text of the catalogue with any other numbers of the same signs.</param>
    public static double[] In(string text, string message)
    {
        var pattern = string.Concat(Number().Split(message).Select((part, i) => i % 2 == 0 ? Regex.Escape(part) : Hole));
        var found = Regex.Match(text, pattern);

        Assert.That(found.Success, Is.True, $"expected: {message}\nbut was: {text}");
        return [.. found.Groups.Values.Skip(1).Select(group => double.Parse(group.Value, CultureInfo.InvariantCulture))];
    }

    const string Hole = @"(-?\d+(?:\.\d+)?)";

    [GeneratedRegex(Hole)]
    private static partial Regex Number();
}
