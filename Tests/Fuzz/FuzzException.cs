namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Thrown if a property that must hold for every input does not hold.</summary>
sealed class FuzzException(string message) : Exception(message);
