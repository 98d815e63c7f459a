namespace UnityEngine;

/// <summary>Makes a world the current one. Disposing the scope restores the previous world.</summary>
readonly struct WorldScope : IDisposable
{
    readonly World _before;

    internal WorldScope(World world) => _before = World.MakeCurrent(world);

    public void Dispose() => World.MakeCurrent(_before);
}
