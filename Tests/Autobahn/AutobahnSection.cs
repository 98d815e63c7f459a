namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases that differ in a number or a few bytes: a row of the document's table.</summary>
/// <param name="Number">The suite's numbers, "2.7–2.9".</param>
/// <param name="What">What is sent.</param>
/// <param name="Note">Where we differ from the suite, and why; empty where we do not.</param>
sealed record AutobahnSection(string Number, string What, string Note, AutobahnCase[] Cases);
