namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Cases that differ in a number or a few bytes: one row of the document's table.</summary>
/// <param name="Number">The suite's numbers, such as "2.7–2.9".</param>
/// <param name="What">Description of the sent frames.</param>
/// <param name="Note">Difference from the suite and its reason; empty if there is none.</param>
sealed record AutobahnSection(string Number, string What, string Note, AutobahnCase[] Cases);
