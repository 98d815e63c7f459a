namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Thrown when a property that must hold for every input does not hold.</summary>
sealed class FuzzException(string message) : Exception(message);
