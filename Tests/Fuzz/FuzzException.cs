namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>A property that must hold of every input did not.</summary>
sealed class FuzzException(string message) : Exception(message);
