using System.Reflection;
using Nowpose.Editor;
using Nowpose.Editor.Import;
using Nowpose.Kinematics;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Robots of a user's project, imported on the editor's stand-in.</summary>
public sealed class UrdfImporterTests : EditorFixture
{
    const string Urdf = "Assets/arm_description/urdf/arm.urdf";
    const string Moved = "<origin xyz='1 2 3' rpy='0.3 -0.2 0.7'/>";

    ProjectFolder _project;
    AssetImportContext _context;

    [SetUp]
    public void SetUp()
    {
        _project = new ProjectFolder();
        _project.Write("Packages/manifest.json", "{}");
        Project.Open(_project.Root);
    }

    [TearDown]
    public void TearDown() => _project.Dispose();

    [Test]
    public void Import_Shapes_HaveTheirSizesAndColours()
    {
        var robot = Import("<link name='base'>"
            + Visual("<box size='1 2 3'/>", Moved, "<material name='m'><color rgba='1 0.5 0 1'/></material>")
            + Visual("<cylinder radius='0.5' length='4'/>") + Visual("<sphere radius='2'/>") + "</link>");

        var shown = robot.transform.Find("base").Cast<Transform>().ToArray();
        Assert.That(shown.Select(s => s.GetComponent<MeshFilter>().sharedMesh.name), Is.EqualTo(new[] { "Cube", "Cylinder", "Sphere" }));
        Assert.That(shown.Select(s => s.localScale), Is.EqualTo(new[] { new Vector3(2, 3, 1), new Vector3(1, 2, 1), new Vector3(4, 4, 4) }));
        Assert.That(shown[0].localPosition, Is.EqualTo(new Vector3(-2, 3, 1)));
        Assert.That(shown[0].GetComponent<Renderer>().sharedMaterial.name, Is.EqualTo("#ff8000ff"));
        Assert.That(shown[1].GetComponent<Renderer>().sharedMaterial.name, Is.EqualTo("#ccccccff"));
        Assert.That(shown[2].GetComponent<Renderer>().sharedMaterial, Is.SameAs(shown[1].GetComponent<Renderer>().sharedMaterial));
        Assert.That(_context.Errors.Concat(_context.Warnings), Is.Empty);
    }

    [Test]
    public void Import_AnyRobot_HasARigOnTopAndItsDescription()
    {
        var robot = Import("<link name='base'/>");

        Assert.That(robot.name, Is.EqualTo("arm"));
        Assert.That(robot.GetComponent<RobotRig>() != null);
        Assert.That(_context.mainObject, Is.SameAs(robot));
        Assert.That(Objects().OfType<RobotDescriptionAsset>().Single().Urdf, Is.EqualTo(_project.Read(Urdf)));
        Assert.That(Objects().OfType<RobotDescriptionAsset>().Single().Read().Root.Name, Is.EqualTo("base"));
    }

    [TestCase("<mesh filename='../meshes/a.stl'/>", 1, 1, 1)]
    [TestCase("<mesh filename='package://arm_description/meshes/a.stl'/>", 1, 1, 1)]
    [TestCase("<mesh filename='../meshes/a.stl' scale='0.001 0.002 -0.003'/>", 0.001, 0.002, -0.003)]
    public void Import_Stl_IsPlacedByItsCoordinates(string mesh, double x, double y, double z)
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0"), ("10 20 30", "11 20 30", "10 20 31")));

        var robot = Import("<link name='base'>" + Visual(mesh, Moved) + "</link>");

        var shown = robot.transform.Find("base/visual");
        var at = shown.TransformPoint(shown.GetComponent<MeshFilter>().sharedMesh.vertices[3]);
        RequireAt(at, RigidTransform.FromXyzRpy(1, 2, 3, 0.3, -0.2, 0.7) * RigidTransform.FromXyzRpy(10 * x, 20 * y, 30 * z, 0, 0, 0));
        Assert.That(_context.SourceDependencies, Is.EqualTo(new[] { "Assets/arm_description/meshes/a.stl" }));
        Assert.That(_context.Warnings, Is.Empty);
    }

    [Test]
    public void Import_Stl_FacesOutwards()
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1e-3 0 0", "0 1e-3 0")));

        Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link>");

        // Anticlockwise about the file's z, which is Unity's y. Unity draws triangles that are clockwise.
        var mesh = Objects().OfType<Mesh>().Single();
        var corners = mesh.triangles.Select(i => mesh.vertices[i]).ToArray();
        Assert.That(mesh.normals, Is.All.EqualTo(Vector3.up));
        Assert.That(Vector3.Dot(Vector3.Cross(corners[1] - corners[0], corners[2] - corners[0]), Vector3.up), Is.GreaterThan(0));
    }

    [Test]
    public void Import_Stl_SharesCornersOfAPlaneAndKeepsEdgesSharp()
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(
            ("0 0 0", "1 0 0", "1 1 0"), ("0 0 0", "1 1 0", "0 1 0"), ("0 0 0", "0 1 0", "0 0 1")));

        Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link>");

        var mesh = Objects().OfType<Mesh>().Single();
        Assert.That(mesh.triangles.Length, Is.EqualTo(9));
        Assert.That(mesh.vertexCount, Is.EqualTo(4 + 3));
    }

    [Test]
    public void Import_StlOfManyCorners_HasLongIndices()
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(Enumerable.Range(0, 22_000)
            .Select(i => ($"{i} 0 0", $"{i} 1 0", $"{i} 0 {1 + i % 7}")).ToArray()));

        Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link>");

        Assert.That(Objects().OfType<Mesh>().Single().indexFormat, Is.EqualTo(UnityEngine.Rendering.IndexFormat.UInt32));
    }

    [Test]
    public void Import_StlUsedTwice_IsOneMesh()
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));

        Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>")
            + Visual("<mesh filename='package://arm_description/meshes/a.stl'/>") + "</link>");

        Assert.That(Objects().OfType<Mesh>().Count(), Is.EqualTo(1));
    }

    [TestCase("a.obj", UpAxis.Y, false)]
    [TestCase("a.dae", UpAxis.X, false)]
    [TestCase("a.DAE", UpAxis.Y, false)]
    [TestCase("a.dae", UpAxis.Z, false)]
    [TestCase("a.fbx", UpAxis.Y, false)]
    [TestCase("a.fbx", UpAxis.Z, false)]
    [TestCase("a.fbx", UpAxis.Z, true)]
    public void Import_Model_IsPlacedByItsCoordinates(string file, object up, bool isBaked)
    {
        var path = "Assets/arm_description/meshes/" + file;
        _project.Write(path, Header(file, (UpAxis)up));
        Project.Put(path, AsUnityImports((10, 20, 30), (UpAxis)up, isBaked));

        var robot = Import("<link name='base'>" + Visual($"<mesh filename='../meshes/{file}' scale='0.1 0.2 -0.3'/>", Moved) + "</link>");

        var shown = robot.GetComponentInChildren<MeshFilter>();
        RequireAt(
            shown.transform.TransformPoint(shown.sharedMesh.vertices[0]),
            RigidTransform.FromXyzRpy(1, 2, 3, 0.3, -0.2, 0.7) * RigidTransform.FromXyzRpy(1, 4, -9, 0, 0, 0));
        Assert.That(_context.ArtifactDependencies, Does.Contain(path));
        Assert.That(_context.Warnings, Is.Empty);
    }

    [Test]
    public void Import_Model_IsACopyWithoutForeignComponents()
    {
        _project.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        var model = AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true);
        model.AddComponent<Camera>();
        Project.Put("Assets/arm_description/meshes/a.obj", model);

        var robot = Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.obj'/>") + "</link>");

        Assert.That(robot.GetComponentsInChildren<Camera>(true), Is.Empty);
        Assert.That(model.GetComponent<Camera>() != null, "the model itself stays");
        Assert.That(robot.GetComponentInChildren<MeshFilter>().sharedMesh, Is.SameAs(model.GetComponent<MeshFilter>().sharedMesh));
        Assert.That(robot.GetComponentInChildren<Renderer>().sharedMaterial, Is.SameAs(model.GetComponent<Renderer>().sharedMaterial));
    }

    [Test]
    public void Import_ModelWithPartsNamedLikeLinks_IsDistinguished()
    {
        _project.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        var model = AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true);
        new GameObject("tip").transform.SetParent(model.transform);
        Project.Put("Assets/arm_description/meshes/a.obj", model);

        var robot = Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.obj'/>") + "</link><link name='tip'/>"
            + "<joint name='j' type='revolute'><parent link='base'/><child link='tip'/></joint>");

        var rig = robot.GetComponent<RobotRig>();
        rig.Bind(Objects().OfType<RobotDescriptionAsset>().Single().Read());
        Assert.That(rig.Link("tip"), Is.SameAs(robot.transform.Find("base/tip")));
    }

    [Test]
    public void Import_SeveralOfOneKind_HaveUniqueNames()
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));
        _project.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        var model = AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true);
        foreach (var part in new[] { "left", "right" }) new GameObject(part).transform.SetParent(model.transform);
        Project.Put("Assets/arm_description/meshes/a.obj", model);

        var robot = Import("<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + Visual("<mesh filename='../meshes/a.obj'/>")
            + Visual("<box size='1 1 1'/>") + "</link>");

        Assert.That(robot.transform.Find("base").Cast<Transform>().Select(s => s.name), Is.EqualTo(new[] { "visual", "visual 2", "visual 3" }));
        var copy = robot.transform.Find("base/visual 2/axes/mesh");
        Assert.That(copy.Cast<Transform>().Select(s => s.name), Is.EqualTo(new[] { "mesh", "mesh 2" }));
        Assert.That(_context.Warnings, Is.Empty);
    }

    [Test]
    public void Import_WithMaterialsChosen_UsesThemForEverything()
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));
        _project.Write("Assets/arm_description/meshes/a.obj", "v 0 0 0");
        Project.Put("Assets/arm_description/meshes/a.obj", AsUnityImports((1, 2, 3), UpAxis.Y, isBaked: true));
        Material arm = NewMaterial(), tool = NewMaterial();
        var importer = new UrdfImporter();
        Set(importer, "_armMaterial", arm);
        Set(importer, "_toolMaterial", tool);

        var robot = Import(
            "<link name='base'>" + Visual("<box size='1 1 1'/>") + Visual("<mesh filename='../meshes/a.obj'/>") + "</link>"
            + "<link name='flange'>" + Visual("<mesh filename='../meshes/a.stl'/>") + "</link><link name='tool0'>"
            + Visual("<sphere radius='1'/>") + Visual("<mesh filename='../meshes/a.obj'/>") + "</link>"
            + "<joint name='j' type='revolute'><parent link='base'/><child link='flange'/></joint>"
            + "<joint name='k' type='fixed'><parent link='flange'/><child link='tool0'/></joint>", importer);

        var materials = robot.GetComponentsInChildren<Renderer>().Select(r => r.sharedMaterial);
        Assert.That(materials, Is.EqualTo(new[] { arm, arm, arm, tool, tool }));
        Assert.That(Objects().OfType<Material>(), Is.Empty);
    }

    [Test]
    public void Import_MeshMissing_CausesOneWarningAndImportsTheRest()
    {
        var robot = Import("<link name='base'>" + Visual("<mesh filename='package://other/a.dae'/>")
            + Visual("<mesh filename='package://other/a.dae'/>") + Visual("<box size='1 1 1'/>") + "</link>");

        Assert.That(robot.transform.Find("base").childCount, Is.EqualTo(1));
        Assert.That(_context.Warnings.Single(), Does.StartWith("arm.urdf: mesh 'package://other/a.dae' was not found; searched at Assets/"));
        Assert.That(_context.Errors, Is.Empty);
        Assert.That(_context.SourceDependencies, Does.Contain("Assets/arm_description/other/a.dae"));
        Assert.That(_context.SourceDependencies, Does.Contain("Packages/other/a.dae"));
    }

    [Test]
    public void Import_LinkOfMissingMeshesOnly_IsDrawnAsBars()
    {
        var robot = Import("<link name='base'>" + Visual("<mesh filename='a.stl'/>") + "</link><link name='tip'/>"
            + "<joint name='j' type='fixed'><parent link='base'/><child link='tip'/><origin xyz='0 0 2'/></joint>");

        var bar = robot.GetComponentInChildren<Renderer>();
        Assert.That(bar.transform.localPosition, Is.EqualTo(new Vector3(0, 1, 0)));
        Assert.That(bar.sharedMaterial != null);
    }

    [TestCase("a.stl", "solid a\nfacet\nvertex 0 0\n", "arm.urdf: Assets/arm_description/urdf/a.stl:3: a vertex has 2 numbers; it needs 3")]
    [TestCase("a.ply", "ply", "arm.urdf: mesh 'a.ply' has an unsupported format; allowed are STL, OBJ, DAE and FBX")]
    [TestCase("a.fbx", "broken", "arm.urdf: mesh Assets/arm_description/urdf/a.fbx: Unity has not imported it; see its import log for the reason")]
    public void Import_MeshInvalid_CausesOneWarningWithItsName(string file, string content, string warning)
    {
        _project.Write("Assets/arm_description/urdf/" + file, content);

        Import($"<link name='base'>{Visual($"<mesh filename='{file}'/>")}{Visual($"<mesh filename='{file}'/>")}</link>");

        Assert.That(_context.Warnings, Is.EqualTo(new[] { warning }));
        Assert.That(_context.Errors, Is.Empty);
        Assert.That(_context.ArtifactDependencies.Concat(_context.SourceDependencies), file == "a.ply"
            ? Is.Empty
            : Is.EqualTo(new[] { "Assets/arm_description/urdf/" + file }), "imported again once it is repaired");
    }

    [TestCase("<link name='a'/>\n<link name='b'/>", "arm.urdf:3: link 'b': there are two root links, this one and 'a'")]
    [TestCase("<link", "arm.urdf:3: not well-formed XML")]
    public void Import_NotARobot_CausesOneErrorWithFileAndLine(string body, string error)
    {
        Assert.That(Import(body) == null);
        Assert.That(_context.Errors.Single(), Does.StartWith(error));
        Assert.That(Objects(), Is.Empty);
    }

    [Test]
    public void Import_FileTooLong_CausesOneErrorWithoutReading()
    {
        _project.Write(Urdf, "");
        using (var file = File.OpenWrite(Path.Combine(_project.Root, Urdf))) file.SetLength((16 << 20) + 1);

        _context = Importers.Import(new UrdfImporter(), Urdf).Context;

        Assert.That(_context.Errors, Is.EqualTo(new[] { "arm.urdf: 16777217 bytes; the maximum is 16777216" }));
    }

    [Test]
    public void Import_Twice_HasTheSameIdentifiers()
    {
        _project.Write("Assets/arm_description/meshes/a.stl", Stl(("0 0 0", "1 0 0", "0 1 0")));
        var body = "<link name='base'>" + Visual("<mesh filename='../meshes/a.stl'/>") + Visual("<box size='1 1 1'/>") + "</link>";
        Import(body);
        var once = _context.Identifiers;

        Import(body);

        Assert.That(_context.Identifiers, Is.EquivalentTo(once));
        Assert.That(once, Is.EquivalentTo(new[] { "robot", "description", "mesh Assets/arm_description/meshes/a.stl", "material #ccccccff" }));
    }

    [Test]
    public void Gather_BeforeTheImport_NamesTheExistingModels()
    {
        _project.Write("Assets/arm_description/meshes/a.dae", "");
        _project.Write("Assets/arm_description/meshes/a.stl", "");
        _project.Write(Urdf, Robot("<link name='base'>" + Visual("<mesh filename='../meshes/a.dae'/>") + Visual("<mesh filename='../meshes/a.dae'/>")
            + Visual("<mesh filename='../meshes/b.dae'/>") + Visual("<mesh filename='../meshes/a.stl'/>") + Visual("<sphere radius='1'/>") + "</link>"));

        Assert.That(Gather(Urdf), Is.EqualTo(new[] { "Assets/arm_description/meshes/a.dae" }));
    }

    [TestCase("<link")]
    [TestCase(null)]
    public void Gather_InvalidRobot_IsEmpty(string body)
    {
        if (body != null) _project.Write(Urdf, Robot(body));

        Assert.That(Gather(Urdf), Is.Empty);
    }

    static string[] Gather(string path) => Project.InRoot(() => (string[])typeof(UrdfImporter)
        .GetMethod("GatherDependenciesFromSourceFile", BindingFlags.Static | BindingFlags.NonPublic).Invoke(null, new object[] { path }));

    GameObject Import(string body, UrdfImporter importer = null)
    {
        _project.Write(Urdf, Robot(body));
        var imported = Importers.Import(importer ?? new UrdfImporter(), Urdf);
        _context = imported.Context;
        foreach (var made in imported.Objects) Keep(made);
        return (GameObject)_context.mainObject;
    }

    IEnumerable<Object> Objects()
    {
        var objects = new List<Object>();
        _context.GetObjects(objects);
        return objects;
    }

    static string Robot(string body) => "<robot name='r'>\n" + body + "\n</robot>";

    static string Visual(string geometry, string origin = "", string material = "") =>
        "<visual>" + origin + "<geometry>" + geometry + "</geometry>" + material + "</visual>";

    static string Stl(params (string A, string B, string C)[] facets) => "solid a\n" + string.Concat(facets.Select(
        f => $"facet normal 0 0 0\nouter loop\nvertex {f.A}\nvertex {f.B}\nvertex {f.C}\nendloop\nendfacet\n")) + "endsolid\n";

    static string Header(string file, UpAxis up) => Path.GetExtension(file).ToLowerInvariant() switch
    {
        ".dae" => $"<COLLADA><asset><up_axis>{up}_UP</up_axis></asset></COLLADA>",
        ".fbx" => $"; FBX\nP: \"UpAxis\", \"int\", \"Integer\", \"\",{(int)up}\n",
        _ => "v 0 0 0",
    };

    /// <summary>Mirrors x, and rotates the up axis to y, with the root's rotation or (if baked) in the vertices.</summary>
    GameObject AsUnityImports((float X, float Y, float Z) point, UpAxis up, bool isBaked)
    {
        var model = Keep(new GameObject("model"));
        var turn = up switch
        {
            UpAxis.X => Quaternion.Euler(0, 0, -90),
            UpAxis.Z => Quaternion.Euler(-90, 0, 0),
            _ => Quaternion.identity,
        };
        var mirrored = new Vector3(-point.X, point.Y, point.Z);
        model.transform.localRotation = isBaked ? Quaternion.identity : turn;
        model.AddComponent<MeshFilter>().sharedMesh = Keep(new Mesh { vertices = new[] { isBaked ? turn * mirrored : mirrored } });
        model.AddComponent<MeshRenderer>().sharedMaterial = NewMaterial();
        return model;
    }

    Material NewMaterial() => Keep(new Material(Shader.Find("Standard")));

    static void Set(object target, string field, object value) =>
        target.GetType().GetField(field, BindingFlags.Instance | BindingFlags.NonPublic).SetValue(target, value);

    static void RequireAt(Vector3 actual, RigidTransform expected)
    {
        var (x, y, z) = UnityFrame.DirectionToUnity((expected.X, expected.Y, expected.Z));
        Assert.That(Vector3.Distance(actual, new Vector3((float)x, (float)y, (float)z)), Is.LessThan(1e-5f), actual + " is not " + (x, y, z));
    }
}
