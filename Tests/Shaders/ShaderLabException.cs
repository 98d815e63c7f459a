namespace Nowpose.Headless.Tests.Shaders;

/// <summary>A shader file has a structure that Unity would refuse, or that this check does not know.</summary>
public sealed class ShaderLabException : Exception
{
    public ShaderLabException(string file, int line, string problem)
        : base($"{file}:{line}: {problem}")
    {
    }
}
