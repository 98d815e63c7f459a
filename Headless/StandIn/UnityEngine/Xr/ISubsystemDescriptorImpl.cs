namespace UnityEngine;

interface ISubsystemDescriptorImpl
{
}
