namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Thrown for a shader file whose structure Unity would refuse or this check does not support.</summary>
public sealed class ShaderLabException : Exception
{
    public ShaderLabException(string file, int line, string problem)
        : base($"{file}:{line}: {problem}")
    {
    }
}
