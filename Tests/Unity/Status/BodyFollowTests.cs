using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Status;

public class BodyFollowTests
{
    PlayedCell _cell;
    Transform _head;
    Transform _follower;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _follower = new GameObject("Follower").AddComponent<BodyFollow>().transform;
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Run(double seconds) => _cell.Run(seconds, null);

    void AddCamera()
    {
        _head = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        _head.position = new Vector3(0, 1.6f, 0);
    }

    float Azimuth => Mathf.Atan2(_follower.position.x - _head.position.x, _follower.position.z - _head.position.z) * Mathf.Rad2Deg;

    [Test]
    public void LateUpdate_HeadTurnsFar_FollowsGradually()
    {
        AddCamera();
        _cell.Frame(null);
        var first = Azimuth;

        _head.rotation = Quaternion.Euler(0, 90, 0);
        Run(0.2);
        var soon = Azimuth;
        Run(4);

        Assert.That(first, Is.EqualTo(0).Within(0.1));
        Assert.That(soon, Is.InRange(20, 60), "the object moves gradually");
        Assert.That(Azimuth, Is.EqualTo(90).Within(0.6));
        Assert.That(_follower.up.y, Is.EqualTo(1).Within(1e-5));
    }

    [Test]
    public void LateUpdate_HeadMovesLittle_DoesNotMove()
    {
        AddCamera();
        _cell.Frame(null);
        var before = (_follower.position, _follower.rotation);

        for (var i = 0; i < 300; i++)
        {
            _head.SetPositionAndRotation(
                new Vector3(0.1f * Mathf.Sin(i), 1.6f + 0.1f * Mathf.Cos(i), 0), Quaternion.Euler(20 * Mathf.Sin(i), 25 * Mathf.Cos(i), 10));
            _cell.Frame(null);
        }

        Assert.That(_follower.position.Equals(before.position) && _follower.rotation.Equals(before.rotation), Is.True);
    }

    [Test]
    public void LateUpdate_CameraAddedLater_IsPlaced()
    {
        _follower.position = new Vector3(9, 9, 9);
        Run(0.2);
        var before = _follower.position;
        AddCamera();

        _cell.Frame(null);

        Assert.That(before, Is.EqualTo(new Vector3(9, 9, 9)));
        Assert.That(Vector3.Distance(_follower.position, _head.position), Is.EqualTo(1.3f).Within(1e-4));
    }

    [Test]
    public void OnEnable_DisabledBeforeTheFirstFrame_KeepsItsPlace()
    {
        AddCamera();
        var panel = new GameObject("Panel");
        panel.SetActive(false);
        panel.transform.position = new Vector3(4, 1, 0);
        var follow = panel.AddComponent<BodyFollow>();

        panel.SetActive(true);
        follow.enabled = false;
        _cell.Frame(null);

        Assert.That(panel.transform.position, Is.EqualTo(new Vector3(4, 1, 0)));
    }

    [Test]
    public void OnEnable_EnabledAgain_IsInFrontOfTheHeadImmediately()
    {
        AddCamera();
        _cell.Frame(null);
        _follower.gameObject.SetActive(false);
        _head.position = new Vector3(20, 1.6f, 5);
        _cell.Frame(null);

        _follower.gameObject.SetActive(true);
        _cell.Frame(null);

        Assert.That(Vector3.Distance(_follower.position, _head.position), Is.EqualTo(1.3f).Within(1e-4), "the object is in front of the head at once");
    }
}
