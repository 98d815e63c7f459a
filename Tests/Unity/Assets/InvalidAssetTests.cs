using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Assets.ProbedProject;
using static Nowpose.Unity.Tests.Assets.TemporaryProject;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>
/// Tests that invalid assets, which Unity would load with values other than those in the text, are refused. The error must name file, id and field.
/// </summary>
public sealed class InvalidAssetTests
{
    ProbedProject _probed;

    [SetUp]
    public void SetUp() => _probed = new ProbedProject();

    [TearDown]
    public void TearDown() => _probed.Dispose();

    [TestCase("  number: two", "Assets/Arm.prefab &3 LoaderProbe.number: \"two\" is not a valid Int32")]
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
    [TestCase("  other: {fileID: 11}", "LoaderProbe.other: {fileID: 11} is a GameObject, but the field takes a Transform")]
    [TestCase("  transforms:\n  - {fileID: 98}", "&3 MonoBehaviour.transforms: the file has no object 98")]
    [TestCase("  asset: {fileID: 11400000, guid: 000000000000000000000000000000ff, type: 2}", "LoaderProbe.asset: no asset has the GUID")]
    [TestCase("  asset: {fileID: 11400000, guid: 00000000000000000000000000000001, type: 2}",
        "LoaderProbe.asset: refers to an object in Assets/Scripts/LoaderProbe.cs")]
    [TestCase("  asset: {fileID: 11400000, guid: 00000000000000000000000000000003, type: 2}",
        "LoaderProbe.asset: a reference to Assets/Arm.prefab has type: 3")]
    [TestCase("  thing: {fileID: 77, guid: 00000000000000000000000000000003, type: 3}", "LoaderProbe.thing: Assets/Arm.prefab has no object 77")]
    [TestCase("  material: {fileID: 99, guid: 0000000000000000f000000000000000, type: 0}", "LoaderProbe.material: the stand-in has no built-in object")]
    [TestCase("  m_Name: x", "LoaderProbe.m_Name: the stand-in supports only")]
    public void Load_InvalidField_IsRefusedWithFileIdAndField(string fields, string expected)
    {
        Assert.That(() => _probed.Probe(fields), Refused(expected));
    }

    [TestCase("guid: 00000000000000000000000000000001, type: 3", "guid: 00000000000000000000000000000077, type: 3",
        "&3 MonoBehaviour.m_Script: no script has the GUID")]
    [TestCase("guid: 00000000000000000000000000000001, type: 3", "guid: 00000000000000000000000000000002, type: 3",
        "&3 MonoBehaviour.m_Script: Assets/Scripts/LoaderProbeAsset.cs contains no MonoBehaviour")]
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
    [TestCase("  - component: {fileID: 2}\n", "", "a GameObject must have exactly one Transform, as its first component")]
    [TestCase("!u!4 &12\nTransform", "!u!33 &12\nMeshFilter", "a GameObject must have exactly one Transform, as its first component")]
    [TestCase("!u!114 &3\nMonoBehaviour", "!u!999 &3\nWobble", "&3 Wobble: the stand-in does not support class Wobble")]
    [TestCase("m_Layer: 5", "m_Lair: 5", "&1 GameObject: GameObject has no serialised field m_Lair")]
    public void Load_InvalidHierarchy_IsRefused(string good, string bad, string expected)
    {
        var text = Arm.Replace("PROBE\n", "", StringComparison.Ordinal);
        Assert.That(text, Does.Contain(good), "the text contains the part that the test replaces");

        _probed.Project.AddYaml("Assets/Arm.prefab", 3, text.Replace(good, bad, StringComparison.Ordinal));

        Assert.That(() => _probed.Project.Library().Load<GameObject>("Assets/Arm.prefab"),
            Refused(expected));
    }

    [Test]
    public void Load_ObjectIsItsOwnAncestor_IsRefused()
    {
        _probed.Project.AddYaml("Assets/Arm.prefab", 3, Arm.Replace("PROBE\n", "", StringComparison.Ordinal)
            .Replace("m_Children: []", "m_Children:\n  - {fileID: 2}").Replace("m_Father: {fileID: 0}", "m_Father: {fileID: 12}"));

        Assert.That(() => _probed.Project.Library().Load<GameObject>("Assets/Arm.prefab"),
            Refused("Assets/Arm.prefab: some objects are their own ancestors"));
    }

    [Test]
    public void Load_FileMissingOrNameWrong_ErrorNamesTheFile()
    {
        _probed.Project.Add("Assets/Gone.txt", 4, null).AddYaml("Assets/Misnamed.asset", 5, Scriptable("Other", ""));
        var library = _probed.Project.Library();

        Assert.That(() => library.Load<TextAsset>("Assets/Gone.txt"), Refused("Assets/Gone.txt: there is a .meta but no such file"));
        Assert.That(() => library.Load<TextAsset>("Assets/Never.txt"), Refused("Assets/Never.txt: there is no such asset"));
        Assert.That(() => library.Load<LoaderProbeAsset>("Assets/Misnamed.asset"),
            Refused("Misnamed.asset &11400000 MonoBehaviour.m_Name: \"Other\" is not"));
    }

    [Test]
    public void Load_ScriptableObjectOfAnImportedUrdf_IsRefused()
    {
        _probed.Project.Add("Assets/arm.urdf", 4, "<robot/>", "ScriptedImporter");

        Assert.That(() => _probed.Probe("  material: {fileID: 4900000, guid: " + GuidOf(4) + ", type: 3}"), Refused("refers to an object in Assets/arm.urdf"));
    }

    [Test]
    public void Library_TwoMetaFilesWithTheSameGuid_AreRefused()
    {
        _probed.Project.Add("Assets/One.txt", 4, "1").Add("Assets/Two.txt", 4, "2");

        Assert.That(
            () => _probed.Project.Library(), Refused("Assets/Two.txt.meta: guid 00000000000000000000000000000004 is also that of Assets/One.txt"));
    }
}
