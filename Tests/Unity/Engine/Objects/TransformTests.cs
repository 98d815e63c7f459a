using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Objects;

public sealed class TransformTests : PlayerFixture
{
    // World pose of the child, computed in double precision. The parent is at (1, -2, 4), rotated by Euler (30, 40, 50), and scaled by 2.
    static readonly Vector3 ChildPosition = new(4.296289f, -1.446491f, 10.695379f);
    static readonly Quaternion ChildRotation = new(0.1404333f, 0.680817f, 0.6912966f, 0.1971692f);

    Transform _parent;
    Transform _child;

    [SetUp]
    public void MakeTwo()
    {
        _parent = new GameObject("p").transform;
        _parent.SetPositionAndRotation(new Vector3(1, -2, 4), Quaternion.Euler(30, 40, 50));
        _parent.localScale = Vector3.one * 2;
        _child = new GameObject("c").transform;
        _child.SetParent(_parent, false);
        _child.localPosition = new Vector3(1, 2, 3);
        _child.localRotation = Quaternion.Euler(-20, 100, 35);
    }

    [Test]
    public void WorldPose_OfAChild_IsParentTimesLocal()
    {
        AssertAt(_child.position, ChildPosition);
        Assert.That(Quaternion.Angle(_child.rotation, ChildRotation), Is.LessThan(0.01f));
        AssertAt(_child.lossyScale, Vector3.one * 2);
        AssertAt(_child.TransformPoint(Vector3.forward), ChildPosition + ChildRotation * Vector3.forward * 2);
        AssertAt(_child.TransformDirection(Vector3.forward), ChildRotation * Vector3.forward);
    }

    [Test]
    public void InverseTransform_Transform_RoundTrips()
    {
        var point = new Vector3(0.3f, -4, 2);

        AssertAt(_child.InverseTransformPoint(_child.TransformPoint(point)), point);
        AssertAt(_child.InverseTransformDirection(_child.TransformDirection(point)), point);
    }

    [Test]
    public void Position_Set_IsTheWorldPosition()
    {
        _child.position = new Vector3(7, 8, 9);
        _child.rotation = Quaternion.Euler(1, 2, 3);

        AssertAt(_child.position, new Vector3(7, 8, 9));
        Assert.That(Quaternion.Angle(_child.rotation, Quaternion.Euler(1, 2, 3)), Is.LessThan(0.1f));
    }

    [Test]
    public void Parent_Moved_ChildFollows()
    {
        _ = _child.position;

        _parent.position += Vector3.up;

        AssertAt(_child.position, ChildPosition + Vector3.up);
    }

    [Test]
    public void Grandparent_Rotated_GrandchildFollows()
    {
        var top = new GameObject("top").transform;
        _parent.SetParent(top);
        _ = _child.rotation;

        top.rotation = Quaternion.Euler(0, 90, 0);

        AssertAt(_child.position, Quaternion.Euler(0, 90, 0) * ChildPosition);
    }

    [Test]
    public void SetParent_WorldPositionStays_KeepsTheWorldPosition()
    {
        var other = new GameObject("other").transform;
        other.SetPositionAndRotation(new Vector3(-3, 1, 0), Quaternion.Euler(0, 0, 70));
        other.localScale = Vector3.one * 0.5f;

        _child.SetParent(other);

        AssertAt(_child.position, ChildPosition);
        Assert.That(Quaternion.Angle(_child.rotation, ChildRotation), Is.LessThan(0.05f));
        AssertAt(_child.lossyScale, Vector3.one * 2);
        AssertAt(_child.localScale, Vector3.one * 4);
    }

    [Test]
    public void SetParent_WorldPositionDoesNotStay_KeepsTheLocalPose()
    {
        _ = _child.position;

        _child.SetParent(null, false);

        AssertAt(_child.position, new Vector3(1, 2, 3));
        AssertAt(_child.lossyScale, Vector3.one);
    }

    [Test]
    public void SetParent_OwnChild_IsRefused()
    {
        _parent.SetParent(_child);

        Assert.That(_parent.parent, Is.Null);
        Assert.That(Player.Logs.Single().Type, Is.EqualTo(LogType.Error));
    }

    [Test]
    public void Find_NameOrPath_SearchesOneLevelPerName()
    {
        var leaf = new GameObject("leaf").transform;
        leaf.SetParent(_child);

        Assert.That(_parent.Find("c/leaf"), Is.SameAs(leaf));
        Assert.That(_parent.Find("leaf"), Is.Null);
    }

    [Test]
    public void IsChildOf_ItselfAndAncestors_IsTrue()
    {
        Assert.That((_child.IsChildOf(_parent), _child.IsChildOf(_child), _parent.IsChildOf(_child)), Is.EqualTo((true, true, false)));
    }

    [Test]
    public void Transforms_OfManyMovingRobots_AllocateNothing()
    {
        var joints = Enumerable.Range(0, 50).SelectMany(_ => Chain(30)).ToArray();
        Move(joints, 1);

        var before = GC.GetAllocatedBytesForCurrentThread();
        Move(joints, 2);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    static void Move(Transform[] joints, float angle)
    {
        var turn = Quaternion.Euler(angle, 0, 0);
        foreach (var joint in joints) joint.localRotation = turn;
        foreach (var joint in joints) _ = joint.position;
    }

    static IEnumerable<Transform> Chain(int links)
    {
        Transform parent = null;
        for (var i = 0; i < links; i++)
        {
            var link = new GameObject("link").transform;
            link.SetParent(parent, false);
            yield return parent = link;
        }
    }

    static void AssertAt(Vector3 actual, Vector3 expected) =>
        Assert.That(Vector3.Distance(actual, expected), Is.LessThan(5e-6f), $"{actual:F6} is not {expected:F6}");
}
