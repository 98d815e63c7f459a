using System;

namespace UnityEngine;

/// <summary>One world is the current one until this is disposed; then the one before is again.</summary>
readonly struct WorldScope : IDisposable
{
    readonly World _before;

    internal WorldScope(World world) => _before = World.MakeCurrent(world);

    public void Dispose() => World.MakeCurrent(_before);
}
