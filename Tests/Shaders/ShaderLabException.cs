namespace Nowpose.Headless.Tests.Shaders;

/// <summary>Thrown if Unity would reject the structure of a shader file, or if this check does not support it.</summary>
public sealed class ShaderLabException : Exception
{
    public ShaderLabException(string file, int line, string problem)
        : base($"{file}:{line}: {problem}")
    {
    }
}
