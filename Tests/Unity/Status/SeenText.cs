using System.Globalization;
using UnityEngine;

namespace Nowpose.Unity.Tests.Status;

/// <summary>Computes the area of a Text Mesh from the metrics of Unity's built-in font, and the size of its letters as seen from a head.</summary>
static class SeenText
{
    /// <summary>Heights of a capital letter and of a line in Liberation Sans, as fractions of the font size.</summary>
    const float CapitalHeight = 1409 / 2048f, LineHeight = (1854 + 434 + 67) / 2048f;

    /// <summary>Half of the field of view of a HoloLens 2, which is 43° by 29°.</summary>
    const float HalfWidthDegrees = 21.5f, HalfHeightDegrees = 14.5f;

    /// <summary>Advance widths of the characters as fractions of the font size, as read from the font file.</summary>
    public static readonly IReadOnlyDictionary<char, float> Widths = RepositoryFiles
        .Read("Tests/Unity/Status/liberation-sans-widths.csv").Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1)
        .Select(line => line.Split(','))
        .ToDictionary(c => (char)int.Parse(c[0], CultureInfo.InvariantCulture), c => float.Parse(c[1], CultureInfo.InvariantCulture));

    public static float WidthOf(string line) => line.Sum(letter => Widths[letter]);

    /// <summary>Returns the corners, in the world, of the rectangle that a Text Mesh fills.</summary>
    public static Vector3[] Corners(TextMesh text)
    {
        var size = FontSize(text);
        var lines = text.text.Split('\n');
        var (width, height) = (lines.Max(WidthOf) * size, lines.Length * LineHeight * size);
        var left = (int)text.anchor % 3 * -width / 2;
        var top = (int)text.anchor / 3 * height / 2;
        return [At(left, top), At(left + width, top), At(left, top - height), At(left + width, top - height)];

        Vector3 At(float x, float y) => text.transform.TransformPoint(new Vector3(x, y, 0));
    }

    /// <summary>Returns the smallest angle in degrees at which a head sees a capital letter at one of the text's corners.</summary>
    public static float CapitalDegrees(TextMesh text, Transform head)
    {
        var smallest = float.MaxValue;
        foreach (var corner in Corners(text))
        {
            var top = corner + text.transform.up * (CapitalHeight * FontSize(text) * text.transform.lossyScale.y);
            smallest = Mathf.Min(smallest, Vector3.Angle(corner - head.position, top - head.position));
        }
        return smallest;
    }

    public static bool IsInView(Vector3 place, Transform head)
    {
        var seen = head.InverseTransformPoint(place);
        return seen.z > 0 && Degrees(seen.x, seen.z) <= HalfWidthDegrees && Degrees(seen.y, seen.z) <= HalfHeightDegrees;
    }

    /// <summary>Returns the elevation in degrees of a place, as seen from a head that looks horizontally.</summary>
    public static float Elevation(Vector3 place, Transform head)
    {
        var seen = head.InverseTransformPoint(place);
        return Mathf.Atan2(seen.y, seen.z) * Mathf.Rad2Deg;
    }

    static float Degrees(float across, float ahead) => Mathf.Atan2(Mathf.Abs(across), ahead) * Mathf.Rad2Deg;

    static float FontSize(TextMesh text) => 0.1f * text.characterSize * text.fontSize;
}
