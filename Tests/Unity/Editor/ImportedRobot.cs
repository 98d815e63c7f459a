using Nowpose.Editor;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>A temporary project with a robot description, and the objects that its import has created.</summary>
sealed class ImportedRobot : IDisposable
{
    public const string Urdf = "Assets/arm_description/urdf/arm.urdf";
    public const string Moved = "<origin xyz='1 2 3' rpy='0.3 -0.2 0.7'/>";

    readonly EditorFixture _fixture;

    public ImportedRobot(EditorFixture fixture)
    {
        _fixture = fixture;
        Folder = new ProjectFolder();
        Folder.Write("Packages/manifest.json", "{}");
        Project.Open(Folder.Root);
    }

    public ProjectFolder Folder { get; }
    public AssetImportContext Context { get; set; }

    public GameObject Import(string body, UrdfImporter importer = null)
    {
        Folder.Write(Urdf, Robot(body));
        var imported = Importers.Import(importer ?? new UrdfImporter(), Urdf);
        Context = imported.Context;
        foreach (var made in imported.Objects) _fixture.Keep(made);
        return (GameObject)Context.mainObject;
    }

    public IEnumerable<Object> Objects()
    {
        var objects = new List<Object>();
        Context.GetObjects(objects);
        return objects;
    }

    public static string Robot(string body) => "<robot name='r'>\n" + body + "\n</robot>";

    public static string Visual(string geometry, string origin = "", string material = "") =>
        "<visual>" + origin + "<geometry>" + geometry + "</geometry>" + material + "</visual>";

    public static string Stl(params (string A, string B, string C)[] facets) => "solid a\n" + string.Concat(facets.Select(
        f => $"facet normal 0 0 0\nouter loop\nvertex {f.A}\nvertex {f.B}\nvertex {f.C}\nendloop\nendfacet\n")) + "endsolid\n";

    public void Dispose() => Folder.Dispose();
}
