using Nowpose.UnityPlayer.Assets;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Assets.TemporaryProject;

namespace Nowpose.Unity.Tests.Assets;

public sealed class AssetLibraryTests
{
    const string Arm = """
        --- !u!1 &1
        GameObject:
          m_Component:
          - component: {fileID: 2}
          - component: {fileID: 3}
          m_Layer: 5
          m_Name: Arm
          m_TagString: Player
          m_IsActive: 1
        --- !u!4 &2
        Transform:
          m_GameObject: {fileID: 1}
          m_LocalRotation: {x: 0, y: 0.6, z: 0, w: 0.8}
          m_LocalPosition: {x: 1, y: -2, z: 0.25}
          m_LocalScale: {x: 2, y: 2, z: 2}
          m_Children:
          - {fileID: 12}
          m_Father: {fileID: 0}
        --- !u!114 &3
        MonoBehaviour:
          m_GameObject: {fileID: 1}
          m_Enabled: 0
          m_Script: {fileID: 11500000, guid: 00000000000000000000000000000001, type: 3}
        PROBE
        --- !u!1 &11
        GameObject:
          m_Component:
          - component: {fileID: 12}
          m_Name: Hand
          m_IsActive: 0
        --- !u!4 &12
        Transform:
          m_GameObject: {fileID: 11}
          m_Children: []
          m_Father: {fileID: 2}

        """;

    TemporaryProject _project;

    [SetUp]
    public void SetUp()
    {
        _project = new TemporaryProject().AddScript<LoaderProbe>(1).AddScript<LoaderProbeAsset>(2);
    }

    [TearDown]
    public void TearDown() => _project.Dispose();

    [Test]
    public void Load_Prefab_HasHierarchyNamesAndTransforms()
    {
        var arm = Load("");

        Assert.That((arm.name, arm.layer, arm.tag, arm.activeSelf), Is.EqualTo(("Arm", 5, "Player", true)));
        Assert.That(arm.transform.localPosition, Is.EqualTo(new Vector3(1, -2, 0.25f)));
        Assert.That(arm.transform.localRotation, Is.EqualTo(new Quaternion(0, 0.6f, 0, 0.8f)));
        var hand = arm.transform.GetChild(0).gameObject;
        Assert.That((hand.name, hand.activeSelf, arm.transform.childCount), Is.EqualTo(("Hand", false, 1)));
        Assert.That(hand.transform.position, Is.EqualTo(new Vector3(1, -2, 0.25f)));
    }

    [Test]
    public void Load_Prefab_IsNotASceneObjectAndCannotBeDestroyed()
    {
        using var player = new Nowpose.UnityPlayer.Player();
        var before = player.ObjectCount;
        var arm = Load("");

        UnityEngine.Object.Destroy(arm);
        UnityEngine.Object.DestroyImmediate(arm.transform.GetChild(0).gameObject);
        player.Step(1);

        Assert.That(player.ObjectCount, Is.EqualTo(before));
        Assert.That((arm != null, arm.transform.childCount, player.Logs.Count), Is.EqualTo((true, 1, 2)));
        Assert.That(UnityEngine.Object.FindObjectOfType<Transform>(true) == null);
        Assert.That((arm.activeInHierarchy, arm.scene.IsValid()), Is.EqualTo((false, false)));
    }

    [Test]
    public void Load_Fields_OfEveryKind_AreSet()
    {
        _project.AddYaml("Assets/Data.asset", 4, Scriptable("Data", "  _text: hello\n"));

        var probe = Probe("""
              _inherited: 2.5
              _flag: 1
              number: -7
              exact: 1e-3
              text: 'it''s'
              shape: 3
              flags: 3
              place: {x: 1, y: 2, z: 3}
              turn: {x: 0, y: 0, z: 1, w: 0}
              colour: {r: 0.1, g: 0.2, b: 0.3, a: 0.4}
              bytes:
                serializedVersion: 2
                rgba: 4278255873
              other: {fileID: 12}
              thing: {fileID: 11}
              probe: {fileID: 3}
              asset: {fileID: 11400000, guid: 00000000000000000000000000000004, type: 2}
              material: {fileID: 10303, guid: 0000000000000000f000000000000000, type: 0}
              words:
              - one
              - 
              transforms:
              - {fileID: 12}
              - {fileID: 0}
              parts:
              - name: a
                size: 2
                where: {fileID: 2}
              - name: b
              part:
                size: 9
              renamed: 4
            """);

        Assert.That((probe.Inherited, probe.Flag, probe.number, probe.exact, probe.text), Is.EqualTo((2.5f, true, -7, 1e-3, "it's")));
        Assert.That((probe.shape, probe.flags), Is.EqualTo((PrimitiveType.Cube, HideFlags.HideInHierarchy | HideFlags.HideInInspector)));
        Assert.That((probe.place, probe.turn), Is.EqualTo((new Vector3(1, 2, 3), new Quaternion(0, 0, 1, 0))));
        Assert.That(probe.colour, Is.EqualTo(new Color(0.1f, 0.2f, 0.3f, 0.4f)));
        Assert.That((probe.bytes.r, probe.bytes.g, probe.bytes.b, probe.bytes.a), Is.EqualTo((1, 1, 1, 255)));
        var hand = probe.transform.GetChild(0);
        Assert.That((probe.other, probe.thing, probe.probe), Is.EqualTo((hand, hand.gameObject, probe)));
        Assert.That((probe.asset.Text, probe.asset.TextOnEnable, probe.material.name), Is.EqualTo(("hello", "hello", "Default-Material")));
        Assert.That(probe.words, Is.EqualTo(new[] { "one", "" }));
        Assert.That(probe.transforms, Is.EqualTo(new[] { hand, null }));
        Assert.That(probe.parts.Select(p => (p.name, p.size, p.where)),
            Is.EqualTo(new[] { ("a", 2f, probe.transform), ("b", 0.5f, (Transform)null) }));
        Assert.That((probe.part.size, probe.renamed, probe.Deserialised, probe.enabled), Is.EqualTo((9f, 4, -7, false)));
    }

    [Test]
    public void Load_FieldsOmitted_KeepTheirDefaults()
    {
        var probe = Probe("");

        Assert.That((probe.number, probe.text, probe.words.Single(), probe.Inherited), Is.EqualTo((1, "default", "kept unless told otherwise", 1f)));
    }

    [TestCase("oldName")]
    [TestCase("olderName")]
    public void Load_FormerName_SetsTheRenamedField(string name)
    {
        Assert.That(Probe("  " + name + ": 4").renamed, Is.EqualTo(4));
    }

    [Test]
    public void Load_PersistentCalls_RunWhenTheEventIsRaised()
    {
        const string Call = """
                  - m_Target: {fileID: 3}
                    m_TargetAssemblyTypeName: Nowpose.Unity.Tests.Assets.LoaderProbe, Nowpose.Unity.Tests
                    m_MethodName: NAME
                    m_Mode: MODE
                    m_Arguments:
                      m_ObjectArgument: {fileID: 0}
                      m_ObjectArgumentAssemblyTypeName: UnityEngine.Object, UnityEngine
                      m_IntArgument: 42
                      m_FloatArgument: 0
                      m_StringArgument: 
                      m_BoolArgument: 0
                    m_CallState: 1

            """;
        var calls = Call.Replace("NAME", "Call").Replace("MODE", "1") + Call.Replace("NAME", "CallWith").Replace("MODE", "3");
        var probe = Probe("  called:\n    m_PersistentCalls:\n      m_Calls:\n" + calls);

        Assert.That(probe.called.GetPersistentEventCount(), Is.EqualTo(2));
        Assert.That(probe.called.GetPersistentTarget(0), Is.SameAs(probe));
        Assert.That(probe.called.GetPersistentMethodName(1), Is.EqualTo("CallWith"));
        probe.called.Invoke();
        Assert.That(probe.Calls, Is.EqualTo(new[] { 0, 42 }));
    }

    [Test]
    public void Load_AssetsReferringToEachOther_AreTheSameObjects()
    {
        _project.AddYaml("Assets/A.asset", 4, Scriptable("A", "  _next: {fileID: 11400000, guid: " + GuidOf(5) + ", type: 2}\n"))
            .AddYaml("Assets/B.asset", 5, Scriptable("B", "  _next: {fileID: 11400000, guid: " + GuidOf(4) + ", type: 2}\n"));
        var library = _project.Library();

        var a = library.Load<LoaderProbeAsset>("Assets/A.asset");

        Assert.That(a.Next.Next, Is.SameAs(a));
        Assert.That(library.Load<LoaderProbeAsset>("Assets/B.asset"), Is.SameAs(a.Next));
    }

    [Test]
    public void Load_TextAsset_HasTheText()
    {
        _project.Add("Assets/Words.txt", 4, "some words\n");

        Assert.That(_project.Library().Load<TextAsset>("Assets/Words.txt").text, Is.EqualTo("some words\n"));
    }

    [Test]
    public void Load_Material_HasTheShadersDefaultsAndItsOwnValues()
    {
        const string Shader = "Shader \"Test/One\"\n{\n  Properties\n  {\n    // _No (\"No\", Float) = 1\n"
            + "    _Color (\"C\", Color) = (1, 0.5, 0, 1)\n"
            + "    _Fade (\"F (0: none)\", Range(0, 1)) = 0.25\n    _Size (\"S\", Float) = 3\n  }\n  SubShader { }\n}\n";
        const string Material = """
            --- !u!21 &2100000
            Material:
              serializedVersion: 8
              m_Name: Red
              m_Shader: {fileID: 4800000, guid: 00000000000000000000000000000004, type: 3}
              m_CustomRenderQueue: 2900
              m_SavedProperties:
                serializedVersion: 3
                m_TexEnvs: []
                m_Ints: []
                m_Floats:
                - _Size: 7
                m_Colors: []

            """;
        _project.Add("Assets/One.shader", 4, Shader, "ShaderImporter").AddYaml("Assets/Red.mat", 5, Material);

        var red = _project.Library().Load<Material>("Assets/Red.mat");

        Assert.That((red.name, red.shader.name, red.renderQueue), Is.EqualTo(("Red", "Test/One", 2900)));
        Assert.That((red.GetFloat("_Size"), red.GetFloat("_Fade"), red.color), Is.EqualTo((7f, 0.25f, new Color(1, 0.5f, 0, 1))));
        Assert.That(red.HasProperty("_No"), Is.False);
        Assert.That(() => _project.AddYaml("Assets/Red.mat", 5, Material.Replace("_Size", "_Sise")).Library().Load<Material>("Assets/Red.mat"),
            Refused("Assets/Red.mat &2100000 Material.m_SavedProperties.m_Floats._Sise: the shader declares no such property"));
    }

    [TestCase("  number: two", "Assets/Arm.prefab &3 LoaderProbe.number: \"two\" is no Int32")]
    [TestCase("  number: 1e3", "LoaderProbe.number")]
    [TestCase("  number: 3000000000", "LoaderProbe.number")]
    [TestCase("  exact: .nan", "LoaderProbe.exact")]
    [TestCase("  _flag: true", "LoaderProbe._flag")]
    [TestCase("  shape: 77", "LoaderProbe.shape: 77 is not a member of PrimitiveType")]
    [TestCase("  nonsense: 1", "LoaderProbe: LoaderProbe has no serialised field nonsense")]
    [TestCase("  _private: 1", "has no serialised field _private")]
    [TestCase("  unserialised: 1", "has no serialised field unserialised")]
    [TestCase("  unwritable: 1", "has no serialised field unwritable")]
    [TestCase("  unknown: 1", "has no serialised field unknown")]
    [TestCase("  Property: 1", "has no serialised field Property")]
    [TestCase("  place: {x: 1, q: 2}", "LoaderProbe.place: Vector3 has no q")]
    [TestCase("  place: 1", "LoaderProbe.place: has to be named values")]
    [TestCase("  words: one", "LoaderProbe.words: has to be a list")]
    [TestCase("  parts:\n  - nmae: a", "LoaderProbe.parts[0]: LoaderProbePart has no serialised field nmae")]
    [TestCase("  other: 5", "LoaderProbe.other: has to be a reference")]
    [TestCase("  other: {fileID: 99}", "&3 MonoBehaviour.other: the file has no object 99")]
    [TestCase("  other: {fileID: 11}", "LoaderProbe.other: {fileID: 11} is a GameObject, the field takes a Transform")]
    [TestCase("  transforms:\n  - {fileID: 98}", "&3 MonoBehaviour.transforms: the file has no object 98")]
    [TestCase("  asset: {fileID: 11400000, guid: 000000000000000000000000000000ff, type: 2}", "LoaderProbe.asset: no asset has the GUID")]
    [TestCase("  asset: {fileID: 11400000, guid: 00000000000000000000000000000001, type: 2}",
        "LoaderProbe.asset: refers into Assets/Scripts/LoaderProbe.cs")]
    [TestCase("  asset: {fileID: 11400000, guid: 00000000000000000000000000000003, type: 2}",
        "LoaderProbe.asset: a reference to Assets/Arm.prefab has type: 3")]
    [TestCase("  thing: {fileID: 77, guid: 00000000000000000000000000000003, type: 3}", "LoaderProbe.thing: Assets/Arm.prefab has no object 77")]
    [TestCase("  material: {fileID: 99, guid: 0000000000000000f000000000000000, type: 0}", "LoaderProbe.material: the stand-in has no built-in object")]
    [TestCase("  m_Name: x", "LoaderProbe.m_Name: the stand-in supports only")]
    public void Load_InvalidField_IsRefusedWithFileIdAndField(string fields, string expected)
    {
        Assert.That(() => Probe(fields), Refused(expected));
    }

    [TestCase("guid: 00000000000000000000000000000001, type: 3", "guid: 00000000000000000000000000000077, type: 3",
        "&3 MonoBehaviour.m_Script: no script has the GUID")]
    [TestCase("guid: 00000000000000000000000000000001, type: 3", "guid: 00000000000000000000000000000002, type: 3",
        "&3 MonoBehaviour.m_Script: Assets/Scripts/LoaderProbeAsset.cs holds no MonoBehaviour")]
    [TestCase("fileID: 11500000", "fileID: 11400000", "&3 MonoBehaviour.m_Script: has to be")]
    [TestCase("  - {fileID: 12}\n", "  - {fileID: 13}\n", "&2 Transform.m_Children: the file has no object 13")]
    [TestCase("  - {fileID: 12}\n", "  - {fileID: 12}\n  - {fileID: 12}\n", "&2 Transform.m_Children: lists a child twice")]
    [TestCase("m_Children:\n  - {fileID: 12}", "m_Children: []", "&12 Transform.m_Father: &2 does not list it in m_Children")]
    [TestCase("m_Father: {fileID: 2}", "m_Father: {fileID: 0}", "&12 Transform.m_Father: is not &2, which lists it in m_Children")]
    [TestCase("m_Father: {fileID: 2}", "m_Father: {fileID: 1}", "&12 Transform.m_Father: is not &2, which lists it")]
    [TestCase("m_GameObject: {fileID: 11}", "m_GameObject: {fileID: 1}",
        "&12 Transform.m_GameObject: differs from the object that lists this component")]
    [TestCase("  - component: {fileID: 3}\n", "", "&3 MonoBehaviour: is a component that no GameObject lists")]
    [TestCase("  - component: {fileID: 3}\n", "  - component: {fileID: 4}\n", "&1 GameObject.m_Component: the file has no object 4")]
    [TestCase("  - component: {fileID: 2}\n", "", "a GameObject has one Transform, its first component")]
    [TestCase("!u!4 &12\nTransform", "!u!33 &12\nMeshFilter", "a GameObject has one Transform, its first component")]
    [TestCase("!u!114 &3\nMonoBehaviour", "!u!999 &3\nWobble", "&3 Wobble: the stand-in does not support class Wobble")]
    [TestCase("m_Layer: 5", "m_Lair: 5", "&1 GameObject: GameObject has no serialised field m_Lair")]
    public void Load_InvalidHierarchy_IsRefused(string good, string bad, string expected)
    {
        var text = Arm.Replace("PROBE\n", "", StringComparison.Ordinal);
        Assert.That(text, Does.Contain(good), "the test breaks nothing");

        _project.AddYaml("Assets/Arm.prefab", 3, text.Replace(good, bad, StringComparison.Ordinal));

        Assert.That(() => _project.Library().Load<GameObject>("Assets/Arm.prefab"),
            Refused(expected));
    }

    [Test]
    public void Load_AncestorOfItself_IsRefused()
    {
        _project.AddYaml("Assets/Arm.prefab", 3, Arm.Replace("PROBE\n", "", StringComparison.Ordinal)
            .Replace("m_Children: []", "m_Children:\n  - {fileID: 2}").Replace("m_Father: {fileID: 0}", "m_Father: {fileID: 12}"));

        Assert.That(() => _project.Library().Load<GameObject>("Assets/Arm.prefab"),
            Refused("Assets/Arm.prefab: some objects are their own ancestors"));
    }

    [Test]
    public void Load_MissingThings_AreNamed()
    {
        _project.Add("Assets/Gone.txt", 4, null).AddYaml("Assets/Misnamed.asset", 5, Scriptable("Other", ""));
        var library = _project.Library();

        Assert.That(() => library.Load<TextAsset>("Assets/Gone.txt"), Refused("Assets/Gone.txt: there is a .meta but no such file"));
        Assert.That(() => library.Load<TextAsset>("Assets/Never.txt"), Refused("Assets/Never.txt: there is no such asset"));
        Assert.That(() => library.Load<LoaderProbeAsset>("Assets/Misnamed.asset"),
            Refused("Misnamed.asset &11400000 MonoBehaviour.m_Name: \"Other\" is not"));
    }

    [Test]
    public void Load_ScriptableObjectOfAnImportedUrdf_IsRefused()
    {
        _project.Add("Assets/arm.urdf", 4, "<robot/>", "ScriptedImporter");

        Assert.That(() => Probe("  material: {fileID: 4900000, guid: " + GuidOf(4) + ", type: 3}"), Refused("refers into Assets/arm.urdf"));
    }

    [Test]
    public void Library_TwoMetasWithOneGuid_AreRefused()
    {
        _project.Add("Assets/One.txt", 4, "1").Add("Assets/Two.txt", 4, "2");

        Assert.That(() => _project.Library(), Refused("Assets/Two.txt.meta: guid 00000000000000000000000000000004 is also that of Assets/One.txt"));
    }

    static string Scriptable(string name, string fields)
    {
        return "--- !u!114 &11400000\nMonoBehaviour:\n  m_Script: {fileID: 11500000, guid: " + GuidOf(2)
            + ", type: 3}\n  m_Name: " + name + "\n" + fields;
    }

    GameObject Load(string probeFields)
    {
        _project.AddYaml("Assets/Arm.prefab", 3, Arm.Replace("PROBE\n", probeFields.Length == 0 ? "" : probeFields + "\n", StringComparison.Ordinal));
        return _project.Library().Load<GameObject>("Assets/Arm.prefab");
    }

    LoaderProbe Probe(string fields) => Load(fields).GetComponent<LoaderProbe>();

    static NUnit.Framework.Constraints.Constraint Refused(string message)
    {
        return Throws.TypeOf<AssetException>().With.Message.Contains(message);
    }
}
