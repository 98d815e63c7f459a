using System.Text.RegularExpressions;
using Nowpose.UnityPlayer;
using Nowpose.UnityPlayer.Assets;
using NUnit.Framework;
using UnityEngine;
using static Nowpose.Unity.Tests.Assets.PrefabParts;
using static Nowpose.Unity.Tests.Assets.TemporaryProject;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Assets;

public sealed class PrefabInstanceTests
{
    const string HandPath = "Assets/Hand.prefab";
    const string ArmPath = "Assets/Arm.prefab";

    TemporaryProject _project;
    Player _player;

    [SetUp]
    public void SetUp()
    {
        _player = new Player();
        _project = new TemporaryProject().AddScript<LoaderProbe>(1).AddScript<LoaderProbeAsset>(2);
        Save(HandPath, 3, NewHand());
    }

    [TearDown]
    public void TearDown()
    {
        _player.Dispose();
        _project.Dispose();
    }

    [Test]
    public void Prefab_Saved_RoundTrips()
    {
        var hand = Load(HandPath);

        var probe = hand.GetComponent<LoaderProbe>();
        Assert.That((hand.name, probe.text, probe.other.name, probe.parts.Count), Is.EqualTo(("Hand", "of the prefab", "Finger", 2)));
        Assert.That(probe.transform.GetChild(1).localPosition, Is.EqualTo(new Vector3(0.1f, 0, 0)));
        Assert.That(Write(hand), Is.EqualTo(_project.Read(HandPath)));
    }

    [Test]
    public void Instance_PartOfACanvas_KeepsItsPlaceAndChildren()
    {
        var button = new GameObject("Button");
        button.AddComponent<RectTransform>();
        Save("Assets/Button.prefab", 7, button);
        var menu = new GameObject("Menu");
        var inside = _project.Library() is var library ? library.InstantiatePrefab(library.Load<GameObject>("Assets/Button.prefab")) : null;
        inside.transform.SetParent(menu.transform, false);
        ((RectTransform)inside.transform)._anchoredPosition = new Vector2(12, -3);
        NewChild("Label", inside.transform);

        var text = new AssetWriter(library).Prefab(menu);
        _project.AddYaml("Assets/Menu.prefab", 8, text.Substring(YamlHeader.Length));
        var read = Load("Assets/Menu.prefab").transform.GetChild(0);

        Assert.That(text, Does.Contain("propertyPath: m_AnchoredPosition.x\n      value: 12\n"));
        Assert.That(text, Does.Contain("--- !u!224 &").And.Contain(" stripped"), "the parent of the label is a stripped object");
        Assert.That(((RectTransform)read)._anchoredPosition, Is.EqualTo(new Vector2(12, -3)));
        Assert.That(read.GetChild(0).name, Is.EqualTo("Label"));
    }

    [Test]
    public void Instance_Unchanged_EqualsThePrefab()
    {
        var arm = NewArm(out _);
        Save(ArmPath, 4, arm);

        var hand = Load(ArmPath).transform.GetChild(1);

        Assert.That((hand.name, hand.parent.name, hand.localPosition), Is.EqualTo(("Left Hand", "Arm", new Vector3(0, 1, 0))));
        Assert.That(hand.GetComponent<LoaderProbe>().other, Is.SameAs(hand.GetChild(0)));
        Assert.That(Load(HandPath).transform.parent, Is.Null, "the prefab itself");
        Assert.That(_project.Read(ArmPath), Does.Contain("m_SourcePrefab: {fileID: 100100000, guid: " + GuidOf(3) + ", type: 3}"));
        Assert.That(_project.Read(ArmPath), Does.Not.Contain("of the prefab"), "values that do not differ from the prefab are not written");
    }

    [Test]
    public void Instance_Modified_SavesOnlyTheModifiedValues()
    {
        var arm = NewArm(out var hand);
        var probe = hand.GetComponent<LoaderProbe>();
        probe.text = "of the instance";
        probe.colour = new Color(0, 0.5f, 0, 1);
        probe.other = arm.transform;
        probe.thing = hand.transform.GetChild(1).gameObject;
        probe.parts[1].size = 9;
        probe.words = new List<string> { "one", "two", "three" };
        probe.parts.Add(new LoaderProbePart { name = "third", where = arm.transform });
        hand.transform.GetChild(1).gameObject.SetActive(false);

        Save(ArmPath, 4, arm);

        var loaded = Load(ArmPath);
        var saved = loaded.transform.GetChild(1).GetComponent<LoaderProbe>();
        Assert.That((saved.text, saved.colour.g, saved.number), Is.EqualTo(("of the instance", 0.5f, 7)));
        Assert.That((saved.other, saved.thing), Is.EqualTo((loaded.transform, saved.transform.GetChild(1).gameObject)));
        Assert.That(saved.words, Is.EqualTo(new[] { "one", "two", "three" }));
        Assert.That(saved.parts.Select(p => (p.name, p.size)), Is.EqualTo(new[] { ("first", 1f), ("second", 9f), ("third", 0.5f) }));
        Assert.That(saved.parts[2].where, Is.SameAs(loaded.transform));
        Assert.That(saved.transform.GetChild(1).gameObject.activeSelf, Is.False);
        Assert.That(Load(HandPath).GetComponent<LoaderProbe>().text, Is.EqualTo("of the prefab"));
        Assert.That(Write(loaded), Is.EqualTo(_project.Read(ArmPath)));
    }

    [Test]
    public void Instance_ShorterList_IsTruncated()
    {
        var arm = NewArm(out var hand);
        hand.GetComponent<LoaderProbe>().parts.RemoveAt(1);

        Save(ArmPath, 4, arm);

        Assert.That(Load(ArmPath).transform.GetChild(1).GetComponent<LoaderProbe>().parts.Single().name, Is.EqualTo("first"));
    }

    [Test]
    public void Instance_ListEmptyInThePrefab_IsBuiltFromModifications()
    {
        var arm = NewArm(out var hand);
        var probe = hand.GetComponent<LoaderProbe>();
        probe.transforms = new[] { arm.transform, hand.transform };

        Save(ArmPath, 4, arm);

        var loaded = Load(ArmPath).transform;
        Assert.That(loaded.GetChild(1).GetComponent<LoaderProbe>().transforms, Is.EqualTo(new[] { loaded, loaded.GetChild(1) }));
        Assert.That(Write(loaded.gameObject), Is.EqualTo(_project.Read(ArmPath)));
    }

    [Test]
    public void Instance_RemovedAndAddedParts_RoundTrip()
    {
        var arm = NewArm(out var hand);
        Object.DestroyImmediate(hand.GetComponent<LoaderProbe>());
        hand.AddComponent<TextMesh>().text = "added";
        NewChild("Ring", hand.transform.GetChild(0));
        NewChild("Sleeve", hand.transform);

        Save(ArmPath, 4, arm);

        var saved = Load(ArmPath).transform.GetChild(1);
        Assert.That(saved.GetComponent<LoaderProbe>(), Is.Null);
        Assert.That((saved.GetComponent<TextMesh>().text, saved.GetChild(0).GetChild(0).name), Is.EqualTo(("added", "Ring")));
        Assert.That(saved.GetChild(2).name, Is.EqualTo("Sleeve"));
        Assert.That(Write(saved.parent.gameObject), Is.EqualTo(_project.Read(ArmPath)));
    }

    [Test]
    public void Instance_ReferencedByAnotherObject_HasAPlaceholder()
    {
        var arm = NewArm(out var hand);
        var watch = arm.AddComponent<LoaderProbe>();
        watch.probe = hand.GetComponent<LoaderProbe>();
        watch.thing = hand.transform.GetChild(0).gameObject;

        Save(ArmPath, 4, arm);

        var saved = Load(ArmPath);
        Assert.That(saved.GetComponent<LoaderProbe>().probe, Is.SameAs(saved.transform.GetChild(1).GetComponent<LoaderProbe>()));
        Assert.That(saved.GetComponent<LoaderProbe>().thing, Is.SameAs(saved.transform.GetChild(1).GetChild(0).gameObject));
        Assert.That(_project.Read(ArmPath), Does.Match("--- !u!114 &\\d+ stripped\nMonoBehaviour:\n")
            .And.Match("--- !u!1 &\\d+ stripped\nGameObject:\n"));
    }

    [Test]
    public void Instance_OfANestedPrefab_OverridesTheInnermostObject()
    {
        var arm = NewArm(out var hand);
        hand.GetComponent<LoaderProbe>().text = "of the arm";
        Save(ArmPath, 4, arm);
        var library = _project.Library();
        var body = new GameObject("Body");
        var left = Below(body, library.InstantiatePrefab(library.Load<GameObject>(ArmPath)), "Left");
        var right = Below(body, library.InstantiatePrefab(library.Load<GameObject>(ArmPath)), "Right");
        right.transform.GetChild(1).GetComponent<LoaderProbe>().text = "of the body";
        left.transform.GetChild(1).GetComponent<LoaderProbe>().probe = right.transform.GetChild(1).GetComponent<LoaderProbe>();

        _project.Add("Assets/Body.prefab", 5, new AssetWriter(library).Prefab(body), "PrefabImporter");

        var saved = Load("Assets/Body.prefab").transform;
        var probes = saved.GetComponentsInChildren<LoaderProbe>(true);
        Assert.That(probes.Select(p => p.text), Is.EqualTo(new[] { "of the arm", "of the body" }));
        Assert.That(probes.Select(p => p.other.parent), Is.EqualTo(probes.Select(p => p.transform)));
        Assert.That(probes[0].probe, Is.SameAs(probes[1]));
        Assert.That(Write(saved.gameObject), Is.EqualTo(_project.Read("Assets/Body.prefab")));
    }

    [Test]
    public void Scene_WithPrefabInstances_PlaysThem()
    {
        var library = _project.Library();
        var first = library.InstantiatePrefab(library.Load<GameObject>(HandPath));
        first.name = "First";
        var second = library.InstantiatePrefab(library.Load<GameObject>(HandPath));
        second.name = "Second";
        _project.Add("Assets/Two.unity", 6, new AssetWriter(library).Scene(new[] { first, new GameObject("Between"), second }), "DefaultImporter");
        using var player = new Player(_project.Library());

        player.LoadScene("Assets/Two.unity", roots => roots[1].SetActive(false));

        var scene = GameObject.Find("First").scene;
        Assert.That(scene.GetRootGameObjects().Select(g => g.name), Is.EqualTo(new[] { "First", "Between", "Second" }));
        Assert.That(scene.GetRootGameObjects()[1].activeInHierarchy, Is.False, "the object is inactive, as in the file");
        Assert.That(scene.GetRootGameObjects()[2].activeInHierarchy, Is.True);
    }

    [TestCase("propertyPath: text\n", "propertyPath: txet\n", AssetFault.UnknownField, "MonoBehaviour.txet")]
    [TestCase("propertyPath: text\n", "propertyPath: text.more\n", AssetFault.UnknownField, "MonoBehaviour.text", "more")]
    [TestCase("propertyPath: text\n", "propertyPath: parts\n", AssetFault.Kind, "MonoBehaviour.parts")]
    [TestCase("propertyPath: text\n", "propertyPath: parts.Array\n", AssetFault.Kind, "MonoBehaviour.parts", "Array.size or Array.data[n]")]
    [TestCase("propertyPath: text\n", "propertyPath: parts.Array.data[2].name\n", AssetFault.OutOfRange, "MonoBehaviour.parts[2]", "2")]
    [TestCase("propertyPath: text\n", "propertyPath: parts.Array.size\n", AssetFault.Value, "MonoBehaviour.parts", "\"of the instance\"")]
    [TestCase("propertyPath: text\n", "propertyPath: other\n", AssetFault.Kind, "MonoBehaviour.other", "objectReference")]
    [TestCase("value: of the instance\n      objectReference: {fileID: 0}", "value: \n      objectReference: {fileID: 99}",
        AssetFault.MissingObject, "text", "99")]
    [TestCase("m_RemovedComponents: []", "m_RemovedComponents:\n    - {fileID: 9, guid: 00000000000000000000000000000003, type: 3}",
        AssetFault.MissingObject, "PrefabInstance.m_RemovedComponents", "9")]
    [TestCase("m_RemovedComponents: []", "m_AddedComponents:\n    - 1", AssetFault.Unsupported, "m_AddedComponents")]
    [TestCase("m_RemovedComponents: []", "m_Wobble: []", AssetFault.UnknownField, "", "m_Wobble")]
    [TestCase("guid: 00000000000000000000000000000003, type: 3}\n      propertyPath: text",
        "guid: 00000000000000000000000000000004, type: 3}\n      propertyPath: text", AssetFault.Reference, "text")]
    [TestCase("m_SourcePrefab: {fileID: 100100000, guid: 00000000000000000000000000000003",
        "m_SourcePrefab: {fileID: 100100000, guid: 00000000000000000000000000000033", AssetFault.MissingAsset, "PrefabInstance.m_SourcePrefab", "33")]
    [TestCase("m_SourcePrefab: {fileID: 100100000", "m_SourcePrefab: {fileID: 1", AssetFault.Kind, "PrefabInstance.m_SourcePrefab")]
    [TestCase("m_SourcePrefab: {fileID: 100100000, guid: 00000000000000000000000000000003",
        "m_SourcePrefab: {fileID: 100100000, guid: 00000000000000000000000000000004", AssetFault.Hierarchy, "PrefabInstance.m_SourcePrefab", ArmPath)]
    public void Instance_Invalid_IsRefused(string good, string bad, object fault, string place, string detail = "")
    {
        var arm = NewArm(out var hand);
        hand.GetComponent<LoaderProbe>().text = "of the instance";
        Save(ArmPath, 4, arm);
        var text = _project.Read(ArmPath);
        Assert.That(text, Does.Contain(good), "the text contains the part that the test replaces");

        _project.Add(ArmPath, 4, text.Replace(good, bad, StringComparison.Ordinal), "PrefabImporter");

        Assert.That(() => Load(ArmPath), ProbedProject.Refused(fault, place, detail).And.Message.StartsWith(ArmPath));
    }

    [TestCase(@"m_CorrespondingSourceObject: \{fileID: \d+", "m_CorrespondingSourceObject: {fileID: 1",
        AssetFault.MissingObject, "Transform.m_CorrespondingSourceObject")]
    [TestCase(@"m_PrefabInstance: \{fileID: \d+", "m_PrefabInstance: {fileID: 1", AssetFault.Reference, "Transform.m_PrefabInstance")]
    [TestCase("m_CorrespondingSourceObject: ", "m_Source: ", AssetFault.UnknownField, "Transform", "m_CorrespondingSourceObject")]
    public void Placeholder_Invalid_IsRefused(string good, string bad, object fault, string place, string detail = "")
    {
        Save(ArmPath, 4, NewArm(out _));
        var text = _project.Read(ArmPath);
        var stripped = text.IndexOf("stripped", StringComparison.Ordinal);

        _project.Add(ArmPath, 4, text[..stripped] + Regex.Replace(text[stripped..], good, bad), "PrefabImporter");

        Assert.That(() => Load(ArmPath), ProbedProject.Refused(fault, place, detail));
    }

    GameObject NewArm(out GameObject hand)
    {
        var library = _project.Library();
        var arm = new GameObject("Arm");
        NewChild("Elbow", arm.transform);
        hand = Below(arm, library.InstantiatePrefab(library.Load<GameObject>(HandPath)), "Left Hand");
        hand.transform.localPosition = Vector3.up;
        return arm;
    }

    void Save(string path, int guid, GameObject root) => _project.Add(path, guid, Write(root), "PrefabImporter");

    string Write(GameObject root) => new AssetWriter(_project.Library()).Prefab(root);

    GameObject Load(string path) => _project.Library().Load<GameObject>(path);
}
