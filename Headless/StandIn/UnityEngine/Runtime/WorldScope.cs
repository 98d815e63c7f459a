using System;

namespace UnityEngine;

/// <summary>Makes a world the current one until it is disposed, which restores the previous one.</summary>
readonly struct WorldScope : IDisposable
{
    readonly World _before;

    internal WorldScope(World world) => _before = World.MakeCurrent(world);

    public void Dispose() => World.MakeCurrent(_before);
}
