namespace Nowpose.Unity.Tests.Engine.Scripts;

sealed class Derived : HiddenMessages
{
}
