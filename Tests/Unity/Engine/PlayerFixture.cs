using Nowpose.Unity.Tests.Engine.Scripts;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine;

/// <summary>Base class of tests in play mode. Each test has its own player with an empty scene.</summary>
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

    /// <summary>Runs frames of 10 ms, and returns the entries that scripts have written to the journal since the last call.</summary>
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
