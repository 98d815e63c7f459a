namespace Nowpose.UnityPlayer;

/// <summary>Runs frames and the events between them in Unity's order.</summary>
sealed class FrameLoop(World world)
{
    bool _started;
    bool _paused;

    /// <summary>Loads a scene and unloads all others.</summary>
    internal void LoadScene(IReadOnlyList<GameObject> roots)
    {
        var before = new List<SceneContent>(world.Scenes.Loaded);
        world.Scenes.Active = world.Scenes.Add();
        foreach (var scene in before) Unload(scene);
        world.Scenes.Active.Adopt(roots);
    }

    internal void Run(double seconds)
    {
        world.Clock.Advance(seconds);
        SendInitialState();
        world.Gpu.Advance();
        world.Scripts.Start();
        world.Scripts.Update();
        world.Coroutines.Update();
        // Scripts that were added during the updates receive Start in the same frame, before their first LateUpdate.
        world.Scripts.Start();
        world.Scripts.LateUpdate();
        world.Destruction.Flush();
        world.BeforeRender.Invoke();
        world.Cameras.Render();
        world.Coroutines.EndOfFrame();
        world.Destruction.Flush();
    }

    internal void Pause(bool paused)
    {
        if (_paused == paused) return;

        _paused = paused;
        SendPause();
    }

    internal void Focus(bool focused)
    {
        if (world.Host.Focused == focused) return;

        world.Host.Focused = focused;
        SendFocus();
    }

    internal void Quit()
    {
        Send(script => script.Script.Call(Message.OnApplicationQuit, script));
        foreach (var root in world.Scenes.Roots()) world.Destruction.End(root);
    }

    void Unload(SceneContent scene)
    {
        foreach (var root in new List<GameObject>(scene.Roots)) world.Destruction.End(root);
        world.Scenes.Forget(scene);
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

    void SendFocus() => Send(script => RareMessages.Call(script, "OnApplicationFocus", world.Host.Focused));

    // Disabled scripts on active objects also receive these messages.
    void Send(Action<MonoBehaviour> call)
    {
        foreach (var gameObject in world.Scenes.GameObjects())
        {
            if (!gameObject || !gameObject.activeInHierarchy) continue;

            foreach (var component in new List<Component>(gameObject.Components))
            {
                if (component is MonoBehaviour { Awoken: true } script && script) call(script);
            }
        }
    }
}
