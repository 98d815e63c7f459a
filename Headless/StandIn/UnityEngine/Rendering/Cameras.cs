namespace UnityEngine.Rendering;

/// <summary>The enabled cameras of a world, and the delegates called before and after each camera renders.</summary>
sealed class Cameras
{
    readonly List<Camera> _enabled = new();
    Camera.CameraCallback _preRender;
    Camera.CameraCallback _postRender;
    bool _current;

    internal Camera Main => _enabled.Find(c => c.CompareTag("MainCamera"));

    internal int SubscriberCount
    {
        get
        {
            if (_current) Read();
            return Host.Count(_preRender) + Host.Count(_postRender);
        }
    }

    internal void Add(Camera camera) => _enabled.Add(camera);

    internal void Remove(Camera camera) => _enabled.Remove(camera);

    /// <summary>
    /// Sets the static fields of <see cref="Camera"/> to the delegates of this world. Called when this world becomes the current one.
    /// </summary>
    internal void Resume()
    {
        _current = true;
        Camera.onPreRender = _preRender;
        Camera.onPostRender = _postRender;
    }

    internal void Suspend()
    {
        Read();
        _current = false;
    }

    internal void Render()
    {
        SortByDepth();
        // Iterates by index, because a callback may disable a camera.
        for (var i = 0; i < _enabled.Count; i++)
        {
            var camera = _enabled[i];
            Callbacks.Call(Camera.onPreRender, camera);
            Callbacks.Call(Camera.onPostRender, camera);
        }
    }

    // Sorts before each rendering, because scripts may change a depth at any time. The sort is stable and does not allocate.
    void SortByDepth()
    {
        for (var i = 1; i < _enabled.Count; i++)
        {
            for (var k = i; k > 0 && _enabled[k - 1].depth > _enabled[k].depth; k--)
            {
                (_enabled[k - 1], _enabled[k]) = (_enabled[k], _enabled[k - 1]);
            }
        }
    }

    void Read()
    {
        _preRender = Camera.onPreRender;
        _postRender = Camera.onPostRender;
    }
}
