using System.Globalization;
using System.Security;
using System.Text;
using Nowpose.Unity.Status;

namespace Nowpose.Prefabs.Pictures;

/// <summary>
/// Draws a played scene as SVG. Draws Unity's built-in meshes with the package's materials, the farthest face first, and all text on top.
/// </summary>
sealed class SceneDrawing(PictureCamera camera)
{
    /// <summary>Ascent and line height of the built-in font, as multiples of the font size.</summary>
    const double Ascent = 0.905, Line = 1.149;

    const string Occluder = "Nowpose/Occluder";

    readonly MaterialPropertyBlock _block = new();
    readonly StringBuilder _svg = new();

    /// <param name="roots">Objects to draw together with their descendants.</param>
    public string Draw(IEnumerable<GameObject> roots)
    {
        var drawn = roots.Where(root => root.activeInHierarchy).ToList();
        var faces = drawn.SelectMany(root => root.GetComponentsInChildren<MeshRenderer>()).Where(r => r.isVisible).SelectMany(Faces);
        foreach (var face in faces.OrderByDescending(face => Vector3.Distance(face.Centre, camera.Place.position))) Add(face);
        foreach (var text in drawn.SelectMany(root => root.GetComponentsInChildren<TextMesh>()).Where(text => text.text.Length > 0)) Add(text);
        return _svg.ToString();
    }

    IEnumerable<Face> Faces(MeshRenderer renderer)
    {
        var material = renderer.sharedMaterial;
        if (!renderer.TryGetComponent<MeshFilter>(out var filter) || filter.sharedMesh == null || material.shader.name == Occluder) yield break;
        renderer.GetPropertyBlock(_block);
        var colour = material.HasProperty("_Color") ? material.color : new Color(0.55f, 0.55f, 0.55f, 1);
        var (opacity, isStriped) = (HologramLook.Opacity(colour.a, Value(material, "_Fade")), Value(material, "_Hatch") > 0);
        var place = renderer.transform;
        var (centre, scale) = (place.position, place.lossyScale);
        foreach (var corners in Solid.Faces(filter.sharedMesh.name))
        {
            var points = corners.Select(c => (Point: place.TransformPoint(c), Phase: HologramLook.Phase(Vector3.Scale(c, scale)))).ToArray();
            var normal = Vector3.Cross(points[1].Point - points[0].Point, points[2].Point - points[1].Point);
            var middle = points.Aggregate(Vector3.zero, (sum, p) => sum + p.Point) / points.Length;
            var isFlat = filter.sharedMesh.name == "Quad";
            if (!isFlat && Vector3.Dot(normal, middle - centre) < 0) normal = -normal;
            if (!isFlat && Vector3.Dot(normal, camera.Place.position - middle) <= 0) continue;
            yield return new Face(points, HologramLook.Shade(colour, normal, camera.Place.position - middle), opacity, isStriped);
        }
    }

    float Value(Material material, string name)
    {
        if (_block.HasFloat(name)) return _block.GetFloat(name);
        return material.HasProperty(name) ? material.GetFloat(name) : 0;
    }

    void Add(Face face)
    {
        if (!face.IsStriped)
        {
            Add([[.. face.Corners.Select(c => c.Point)]], face.Colour, face.Opacity);
            return;
        }
        Add(face.Stripes(fainter: false), face.Colour, face.Opacity);
        Add(face.Stripes(fainter: true), face.Colour, face.Opacity * HologramLook.StripeKeeps);
    }

    void Add(IEnumerable<Vector3[]> polygons, Color colour, double opacity)
    {
        var path = string.Concat(polygons.Select(polygon => "M" + string.Join("L", polygon.Select(Point)) + "Z"));
        if (path.Length == 0) return;
        _svg.Append(CultureInfo.InvariantCulture, $"""<path d="{path}" fill="{Hex(colour)}" """)
            .Append(CultureInfo.InvariantCulture, $"""fill-opacity="{opacity:0.###}"/>""").Append('\n');
    }

    string Point(Vector3 point)
    {
        var (x, y) = camera.Project(point);
        return string.Create(CultureInfo.InvariantCulture, $"{x:0.0} {y:0.0}");
    }

    void Add(TextMesh text)
    {
        var place = text.transform;
        var size = camera.Size(LetterHeight(text), place.position);
        var (x, y) = camera.Project(place.position);
        var lines = text.text.Split('\n');
        y += Ascent * size - ((int)text.anchor / 3) * lines.Length * Line * size / 2;
        var anchor = ((int)text.anchor % 3) switch { 0 => "start", 1 => "middle", _ => "end" };
        for (var i = 0; i < lines.Length; i++)
            _svg.Append(CultureInfo.InvariantCulture, $"""<text x="{x:0.0}" y="{y + i * Line * size:0.0}" font-size="{size:0.0}" """)
                // Sets the length of the text explicitly, because a browser may use another font.
                .Append(CultureInfo.InvariantCulture, $"""textLength="{LetterWidths.Of(lines[i]) * size:0.0}" lengthAdjust="spacingAndGlyphs" """)
                .Append(CultureInfo.InvariantCulture, $"""text-anchor="{anchor}">{SecurityElement.Escape(lines[i])}</text>""")
                .Append('\n');
    }

    static double LetterHeight(TextMesh text) => 0.1 * text.characterSize * text.fontSize * text.transform.lossyScale.y;

    static string Hex(Color colour)
    {
        Color32 bytes = colour;
        return string.Create(CultureInfo.InvariantCulture, $"#{bytes.r:x2}{bytes.g:x2}{bytes.b:x2}");
    }
}
