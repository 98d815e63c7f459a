using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests;

/// <summary>Whether a renderer shows that the displayed pose is not current.</summary>
static class Hatched
{
    public static bool IsHatched(Renderer renderer)
    {
        var block = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(block);
        return block.GetFloat(Shader.PropertyToID("_Hatch")) > 0;
    }
}
