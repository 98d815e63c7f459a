using Nowpose.Unity.Tests.Engine.Scripts;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine;

/// <summary>Tests in play mode: each has a player of its own with an empty scene.</summary>
public abstract class PlayerFixture
{
    double _time;

    internal Nowpose.UnityPlayer.Player Player { get; private set; }

    [SetUp]
    public void Play()
    {
        Journal.Take();
        Thrower.In = "";
        _time = 0;
        Player = new Nowpose.UnityPlayer.Player();
    }

    [TearDown]
    public void Quit() => Player.Dispose();

    /// <summary>Frames of 10 ms; gives what was noted in them.</summary>
    protected string Frame(int count = 1)
    {
        for (var i = 0; i < count; i++) Player.Step(_time += 0.01);
        return Journal.Take();
    }

    protected static T Add<T>(string name, Transform parent = null) where T : Component
    {
        var made = new GameObject(name).AddComponent<T>();
        made.transform.SetParent(parent, false);
        return made;
    }
}
