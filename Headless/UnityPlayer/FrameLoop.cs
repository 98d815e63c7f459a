using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>The order in which things happen in a frame, and around the frames.</summary>
sealed class FrameLoop
{
    readonly World _world;
    bool _started;

    internal FrameLoop(World world) => _world = world;

    internal void LoadScene(string name, string path, IReadOnlyList<GameObject> roots)
    {
        _world.Scenes.Active = _world.Scenes.Add(name, path);
        _world.Clock.NoteLevelLoad();
        _world.Scenes.Active.Adopt(roots);
    }

    internal void Run(double seconds)
    {
        _world.Clock.Advance(seconds);
        TellTheStart();
        _world.Scripts.Start();
        _world.Scripts.Update();
        _world.Coroutines.Update();
        _world.Scripts.Start();
        _world.Scripts.LateUpdate();
        _world.Destruction.Flush();
        _world.BeforeRender.Invoke();
        _world.Cameras.Render();
        _world.Coroutines.EndOfFrame();
        _world.Destruction.Flush();
        _world.Gpu.Advance();
    }

    internal void Pause(bool paused) => Tell((script, value) => script.Script.Pause(script, value), paused);

    internal void Focus(bool focused)
    {
        _world.Host.ChangeFocus(focused);
        Tell((script, value) => script.Script.Focus(script, value), focused);
    }

    internal void Quit()
    {
        Tell((script, _) => script.Script.Call(Message.OnApplicationQuit, script), true);
        _world.Host.Quit();
        foreach (var root in _world.Scenes.Roots()) _world.Destruction.End(root);
    }

    // Also scripts that are disabled hear these, as long as their object is active.
    void Tell(System.Action<MonoBehaviour, bool> call, bool value)
    {
        foreach (var gameObject in _world.Scenes.GameObjects())
        {
            if (!gameObject || !gameObject.activeInHierarchy) continue;

            foreach (var component in new List<Component>(gameObject.Components))
            {
                if (component is MonoBehaviour { Awoken: true } script && script) call(script, value);
            }
        }
    }

    void TellTheStart()
    {
        if (_started) return;

        _started = true;
        Pause(false);
        Focus(true);
    }
}
