using System;
using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.UnityPlayer;

/// <summary>Runs frames and the events between them in Unity's order.</summary>
sealed class FrameLoop
{
    readonly World _world;
    bool _started;
    bool _paused;

    internal FrameLoop(World world) => _world = world;

    /// <summary>Loads a scene and unloads all others.</summary>
    internal void LoadScene(IReadOnlyList<GameObject> roots)
    {
        var before = new List<SceneContent>(_world.Scenes.Loaded);
        _world.Scenes.Active = _world.Scenes.Add();
        foreach (var scene in before) Unload(scene);
        _world.Scenes.Active.Adopt(roots);
    }

    internal void Run(double seconds)
    {
        _world.Clock.Advance(seconds);
        SendInitialState();
        _world.Gpu.Advance();
        _world.Scripts.Start();
        _world.Scripts.Update();
        _world.Coroutines.Update();
        // Scripts that were added during the updates receive Start in the same frame, before their first LateUpdate.
        _world.Scripts.Start();
        _world.Scripts.LateUpdate();
        _world.Destruction.Flush();
        _world.BeforeRender.Invoke();
        _world.Cameras.Render();
        _world.Coroutines.EndOfFrame();
        _world.Destruction.Flush();
    }

    internal void Pause(bool paused)
    {
        if (_paused == paused) return;

        _paused = paused;
        SendPause();
    }

    internal void Focus(bool focused)
    {
        if (_world.Host.Focused == focused) return;

        _world.Host.Focused = focused;
        SendFocus();
    }

    internal void Quit()
    {
        Send(script => script.Script.Call(Message.OnApplicationQuit, script));
        foreach (var root in _world.Scenes.Roots()) _world.Destruction.End(root);
    }

    void Unload(SceneContent scene)
    {
        foreach (var root in new List<GameObject>(scene.Roots)) _world.Destruction.End(root);
        _world.Scenes.Forget(scene);
    }

    // As in Unity, this happens in the first frame, after Awake of all scripts and before the first Start.
    void SendInitialState()
    {
        if (_started) return;

        _started = true;
        SendPause();
        SendFocus();
    }

    void SendPause() => Send(script => RareMessages.Call(script, "OnApplicationPause", _paused));

    void SendFocus() => Send(script => RareMessages.Call(script, "OnApplicationFocus", _world.Host.Focused));

    // Disabled scripts on active objects also receive these messages.
    void Send(Action<MonoBehaviour> call)
    {
        foreach (var gameObject in _world.Scenes.GameObjects())
        {
            if (!gameObject || !gameObject.activeInHierarchy) continue;

            foreach (var component in new List<Component>(gameObject.Components))
            {
                if (component is MonoBehaviour { Awoken: true } script && script) call(script);
            }
        }
    }
}
